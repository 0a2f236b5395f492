// Simulated flash that can lose power at any step. An erase and the programming of a word take
// several steps, with the intermediate states that real flash may have.
#pragma once

#include <settings_storage/settings_storage.hpp>

#include <array>
#include <cstdint>

namespace gs::test {

class SimulatedFlash : public settings_storage::Flash {
 public:
  static constexpr std::size_t kWords = settings_storage::kSlotBytes / 4;
  static constexpr int kEraseSteps = 8;

  SimulatedFlash() {
    for (auto& slot : slots_) {
      slot.fill(0xFFFFFFFFU);
    }
  }

  // Ignores all writes after this many more steps.
  void cut_power_after(int steps) { steps_left_ = steps; }
  void restore_power() { steps_left_ = kAlways; }
  bool has_power() const { return steps_left_ > 0; }

  void refuse_to_program(bool refuses) { refuses_ = refuses; }
  std::uint32_t& word(int slot, std::size_t offset) {
    return slots_.at(static_cast<std::size_t>(slot)).at(offset / 4);
  }
  int erases(int slot) const { return erases_.at(static_cast<std::size_t>(slot)); }

  bool erase(int slot) override {
    ++erases_.at(static_cast<std::size_t>(slot));
    // Words are erased in a scattered order.
    for (int step = 0; step < kEraseSteps; ++step) {
      if (!take_step()) {
        return true;
      }
      for (std::size_t i = 0; i < kWords; ++i) {
        if ((i * 5 + 3) % kEraseSteps == static_cast<std::size_t>(step)) {
          word(slot, 4 * i) = 0xFFFFFFFFU;
        }
      }
    }
    return true;
  }

  bool program(int slot, std::size_t offset, std::uint32_t value) override {
    if (refuses_) {
      return false;
    }
    // Programs half of the bits, then the other half; from 1 to 0 only.
    for (const std::uint32_t not_yet : {0x5A5A5A5AU, 0U}) {
      if (!take_step()) {
        return true;
      }
      word(slot, offset) &= value | not_yet;
    }
    return true;
  }

  std::uint32_t read(int slot, std::size_t offset) const override {
    return slots_.at(static_cast<std::size_t>(slot)).at(offset / 4);
  }

 private:
  static constexpr int kAlways = 1 << 30;

  bool take_step() {
    if (steps_left_ == 0) {
      return false;
    }
    --steps_left_;
    return true;
  }

  std::array<std::array<std::uint32_t, kWords>, settings_storage::kSlots> slots_ = {};
  std::array<int, settings_storage::kSlots> erases_ = {};
  int steps_left_ = kAlways;
  bool refuses_ = false;
};

}  // namespace gs::test

// Settings in flash, in two slots. One slot holds the newest valid set; a new set is written to the
// other. The new set becomes valid when its last word, the CRC, is written. After a loss of power
// at any time, either the old or the new set is valid.
//
// Format of a slot: magic, sequence number, length (32 bits each, little-endian), the settings as
// CBOR (wire/codec.hpp), padding to a whole 32-bit word, CRC-32 over everything before it.
#pragma once

#include <cstddef>
#include <cstdint>

#include <app/application.hpp>

namespace gs::settings_storage {

// Flash driver of a board. Offsets are within a slot, in bytes, multiples of 4. Calls may block;
// they return false on failure.
class Flash {
 public:
  virtual bool erase(int slot) = 0;
  virtual bool program(int slot, std::size_t offset, std::uint32_t word) = 0;
  virtual std::uint32_t read(int slot, std::size_t offset) const = 0;

 protected:
  ~Flash() = default;
};

constexpr int kSlots = 2;
constexpr std::size_t kSlotBytes = 1024;  // bytes used of each slot, at most

class FlashSettingsStorage final : public app::SettingsStorage {
 public:
  explicit FlashSettingsStorage(Flash& flash) : flash_(flash) {}

  // Loads the newest valid set. Returns false if there is none.
  bool load(outlet::Settings& settings);
  bool keep(const outlet::Settings& settings) override;
  // False if the stored settings are corrupt: a set was completely written, but no set is valid.
  bool usable() const override;

 private:
  Flash& flash_;
};

}  // namespace gs::settings_storage

// Settings in flash, in two slots: a new set goes into the slot that does not hold the newest, and
// counts only once its last word, the CRC, is there. A loss of power at any write leaves the old or
// the new set, never neither.
//
// A slot: magic, sequence number, length (32 bits each, little-endian), the settings as CBOR
// (wire/codec.hpp), padding to a whole word, CRC-32 over all before it.
#pragma once

#include <cstddef>
#include <cstdint>

#include <app/application.hpp>

namespace gs::settings_storage {

// What a board's flash does. Addresses are offsets within a slot, multiples of 4.
class Flash {
 public:
  virtual bool erase(int slot) = 0;
  virtual bool program(int slot, std::size_t offset, std::uint32_t word) = 0;
  virtual std::uint32_t read(int slot, std::size_t offset) const = 0;

 protected:
  ~Flash() = default;
};

constexpr int kSlots = 2;
constexpr std::size_t kSlotBytes = 1024;  // used of each slot, at most

class FlashSettingsStorage final : public app::SettingsStorage {
 public:
  explicit FlashSettingsStorage(Flash& flash) : flash_(flash) {}

  // The newest set that is whole; false where there is none.
  bool load(outlet::Settings& settings);
  bool keep(const outlet::Settings& settings) override;
  // Nothing was ever kept, or what was kept last can be read.
  bool usable() const override;

 private:
  Flash& flash_;
};

}  // namespace gs::settings_storage

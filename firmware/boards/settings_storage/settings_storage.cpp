#include <settings_storage/settings_storage.hpp>

#include <outlet/crc32.hpp>
#include <wire/codec.hpp>

namespace gs::settings_storage {
namespace {

constexpr std::uint32_t kMagic = 0x53545331u;  // "1STS"
constexpr std::uint32_t kBlank = 0xFFFFFFFFu;
constexpr std::size_t kWord = sizeof(std::uint32_t);

// Offsets in a slot.
constexpr std::size_t kMagicAt = 0;
constexpr std::size_t kSequenceAt = 4;
constexpr std::size_t kLengthAt = 8;
constexpr std::size_t kSettingsAt = 12;

static_assert(kSettingsAt + wire::kLongestMessage + kWord <= kSlotBytes);

constexpr std::size_t crc_at(std::size_t length) {
  return kSettingsAt + (length + kWord - 1) / kWord * kWord;
}

bool sensible(std::uint32_t length) {
  return length > 0 && length <= wire::kLongestMessage;
}

std::uint32_t word_of(const std::uint8_t* bytes) {
  return bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
         std::uint32_t{bytes[3]} << 24;
}

std::uint32_t crc_of(const Flash& flash, int slot, std::size_t end) {
  outlet::Crc32 crc;
  for (std::size_t at = 0; at < end; at += kWord) {
    crc.add_word(flash.read(slot, at));
  }
  return crc.value();
}

// True if magic, length and last word are written. After an interrupted write the last word is
// missing.
bool finished(const Flash& flash, int slot) {
  const std::uint32_t length = flash.read(slot, kLengthAt);
  return flash.read(slot, kMagicAt) == kMagic && sensible(length) &&
         flash.read(slot, crc_at(length)) != kBlank;
}

bool whole(const Flash& flash, int slot) {
  if (!finished(flash, slot)) {
    return false;
  }
  const std::size_t end = crc_at(flash.read(slot, kLengthAt));
  return flash.read(slot, end) == crc_of(flash, slot, end);
}

// The slot of the newest valid set, −1 if there is none. Sequence numbers wrap.
int newest(const Flash& flash) {
  const bool first = whole(flash, 0);
  const bool second = whole(flash, 1);
  if (first && second) {
    const std::uint32_t ahead = flash.read(1, kSequenceAt) - flash.read(0, kSequenceAt);
    return ahead != 0 && ahead < 0x80000000u ? 1 : 0;
  }
  return first ? 0 : second ? 1 : -1;
}

bool decode(const Flash& flash, int slot, outlet::Settings& settings) {
  std::uint8_t bytes[wire::kLongestMessage + kWord];
  const std::size_t length = flash.read(slot, kLengthAt);
  for (std::size_t at = 0; at < length; at += kWord) {
    const std::uint32_t word = flash.read(slot, kSettingsAt + at);
    for (std::size_t i = 0; i < kWord; ++i) {
      bytes[at + i] = static_cast<std::uint8_t>(word >> (8 * i));
    }
  }
  return wire::decode(bytes, length, settings) == wire::Decoded::kOk;
}

// Programs successive words, verifies each and updates the CRC.
class SlotWriter {
 public:
  SlotWriter(Flash& flash, int slot) : flash_(flash), slot_(slot) {}

  bool put(std::uint32_t word) {
    crc_.add_word(word);
    const std::size_t at = at_;
    at_ += kWord;
    return flash_.program(slot_, at, word) && flash_.read(slot_, at) == word;
  }
  bool close() { return put(crc_.value()); }

 private:
  Flash& flash_;
  int slot_;
  std::size_t at_ = 0;
  outlet::Crc32 crc_;
};

}  // namespace

bool FlashSettingsStorage::load(outlet::Settings& settings) {
  const int slot = newest(flash_);
  // If another firmware wrote the newest set and it cannot be decoded, the older set is used.
  return slot >= 0 && (decode(flash_, slot, settings) ||
                       (whole(flash_, 1 - slot) && decode(flash_, 1 - slot, settings)));
}

bool FlashSettingsStorage::keep(const outlet::Settings& settings) {
  // Zeros after the settings pad the last word.
  std::uint8_t bytes[wire::kLongestMessage + kWord] = {};
  const std::size_t length = wire::encode(settings, bytes, wire::kLongestMessage);
  if (!sensible(static_cast<std::uint32_t>(length))) {
    return false;
  }
  const int old = newest(flash_);
  const int slot = old == 0 ? 1 : 0;
  const std::uint32_t sequence = old < 0 ? 0 : flash_.read(old, kSequenceAt) + 1;
  if (!flash_.erase(slot)) {
    return false;
  }
  SlotWriter writer(flash_, slot);
  if (!writer.put(kMagic) || !writer.put(sequence) ||
      !writer.put(static_cast<std::uint32_t>(length))) {
    return false;
  }
  for (std::size_t at = 0; at < length; at += kWord) {
    if (!writer.put(word_of(bytes + at))) {
      return false;
    }
  }
  return writer.close();
}

bool FlashSettingsStorage::usable() const {
  // An interrupted first write has no CRC. A finished slot with a wrong CRC is corrupt.
  return newest(flash_) >= 0 || (!finished(flash_, 0) && !finished(flash_, 1));
}

}  // namespace gs::settings_storage

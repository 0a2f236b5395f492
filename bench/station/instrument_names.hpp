// The texts of each closed set of values in an instrument file, with the meaning that is
// documented.
#pragma once

#include <source_scpi/instrument.hpp>

#include <algorithm>
#include <iterator>
#include <string>

namespace gsbench::station::names {

template <class Enum>
struct Named {
  const char* name;
  Enum value;
  const char* meaning;
};

inline constexpr Named<scpi::RateAs> kRateAs[] = {
    {"sample rate", scpi::RateAs::kSampleRate, "points a second"},
    {"frequency", scpi::RateAs::kFrequency, "repetitions of the whole memory a second"}};
inline constexpr Named<scpi::Interpolation> kInterpolations[] = {
    {"hold", scpi::Interpolation::kHold, "a point is held until the next"},
    {"linear", scpi::Interpolation::kLinear, "points are joined by straight lines"}};
inline constexpr Named<scpi::Codes> kCodes[] = {
    {"signed", scpi::Codes::kSigned, "16 bits, −32 767 … 32 767 whatever `bits` is"},
    {"unsigned", scpi::Codes::kUnsigned, "0 … 2^bits − 1"}};
inline constexpr Named<scpi::ByteOrder> kByteOrders[] = {
    {"little", scpi::ByteOrder::kLittle, "low byte first"},
    {"big", scpi::ByteOrder::kBig, "high byte first"}};
inline constexpr Named<scpi::Block> kBlocks[] = {
    {"raw", scpi::Block::kRaw, "the bytes follow the header"},
    {"block", scpi::Block::kBlock, "IEEE 488.2, `#<digits><bytes>`"},
    {"packets", scpi::Block::kPackets, "several such blocks of `packet_points`"}};
inline constexpr Named<scpi::Verification> kVerifications[] = {
    {"read back", scpi::Verification::kReadBack, "the waveform is read and compared byte for byte"},
    {"error queue", scpi::Verification::kErrorQueue, "the error queue must be empty"},
    {"none", scpi::Verification::kNone, "the instrument has no means"}};
inline constexpr Named<scpi::Quirk> kQuirks[] = {
    {"avoid newline", scpi::Quirk::kAvoidNewline,
     "a byte 0x0A in the waveform ends the message; codes are moved off it"},
    {"fixed length", scpi::Quirk::kFixedLength, "a waveform always fills the memory"},
    {"upload switches on", scpi::Quirk::kUploadSwitchesOn,
     "an upload may switch the output on; it is switched off again"},
    {"silent if unknown", scpi::Quirk::kSilentIfUnknown,
     "unknown queries are not answered; the next one is"}};
inline constexpr Named<scpi::When> kWhen[] = {
    {"before upload", scpi::When::kBeforeUpload, "before the waveform is loaded"},
    {"after upload", scpi::When::kAfterUpload, "after it"}};
inline constexpr Named<scpi::Compare> kCompares[] = {
    {"text", scpi::Compare::kText, "in any case"},
    {"number", scpi::Compare::kNumber, "within the tolerance"}};
inline constexpr Named<bool> kMissing[] = {{"refuse", false, "an error"},
                                           {"accept", true, "not compared"}};
inline constexpr Named<bool> kWatched[] = {{"yes", true, "also while the waveform plays"},
                                           {"no", false, "only before"}};

// `name` must be one of the table, which the keys have checked.
template <class Enum, std::size_t Count>
Enum value_of(const std::string& name, const Named<Enum> (&ones)[Count]) {
  return std::find_if(std::begin(ones), std::end(ones),
                      [&](const Named<Enum>& one) { return name == one.name; })
      ->value;
}

}  // namespace gsbench::station::names

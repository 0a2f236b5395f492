#include <wire_test/messages.hpp>

#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include <outlet/settings.hpp>
#include <wire/fields.hpp>

namespace gs::wire::test {
namespace {

constexpr std::uint32_t kNaNBits = 0x7FC00000U;  // the one NaN of the protocol

float float_of(std::uint32_t bits) {
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::uint32_t bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

struct Collector {
  std::vector<Field> fields;

  void integer(std::int64_t value) { fields.push_back({Field::Type::kInteger, value, {}}); }

  void operator()(bool value) { fields.push_back({Field::Type::kBoolean, value ? 1 : 0, {}}); }
  void operator()(float value) {
    fields.push_back({Field::Type::kSingle, std::isnan(value) ? kNaNBits : bits_of(value), {}});
  }
  void operator()(std::uint8_t value) { integer(value); }
  void operator()(std::uint16_t value) { integer(value); }
  void operator()(std::uint32_t value) { integer(value); }
  void operator()(std::int32_t value) { integer(value); }
  template <std::size_t N>
  void operator()(const char (&text)[N]) {
    fields.push_back({Field::Type::kText, 0, text});
  }
  template <class E>
  void choice(E value, E, E = E{}) {
    integer(static_cast<std::uint8_t>(value));
  }

  void settings(const Downlink& message) { settings(message.settings); }
  void settings(const outlet::Settings& settings) {
    fields.push_back({Field::Type::kMap, std::size(outlet::kSettingsFields), {}});
    outlet::visit_fields(settings, *this);
  }
  template <class T>
  void operator()(const outlet::Field& field, const T& value) {
    integer(field.key);
    (*this)(value);
  }
  void rows(const outlet::Field& field, const outlet::ConditionRow* rows, std::uint8_t count) {
    integer(field.key);
    fields.push_back({Field::Type::kArray, 2 * count, {}});
    for (int row = 0; row < count; ++row) {
      (*this)(rows[row].from_hz);
      (*this)(rows[row].rocof_below_hz_s);
    }
  }
};

// Does not use std::uniform_int_distribution, whose values differ between libraries.
class Filler {
 public:
  Filler(Fill fill, std::mt19937& random) : fill_(fill), random_(random) {}

  std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(random_()) % bound; }

  template <class T>
  T integer(T lowest, T highest) {
    switch (fill_) {
      case Fill::kLowest:
        return lowest;
      case Fill::kHighest:
      case Fill::kNaN:
        return highest;
      case Fill::kLongest:
        return lowest < 0 ? lowest : highest;
      case Fill::kAnything:
        break;
    }
    // Small numbers are as frequent as large ones, so that each encoded length occurs.
    const std::uint32_t bits = static_cast<std::uint32_t>(random_()) >> below(32);
    return static_cast<T>(bits);
  }

  void operator()(bool& value) { value = integer<std::uint8_t>(0, 1) % 2 == 1; }
  void operator()(std::uint8_t& value) { value = integer<std::uint8_t>(0, 0xFF); }
  void operator()(std::uint16_t& value) { value = integer<std::uint16_t>(0, 0xFFFF); }
  void operator()(std::uint32_t& value) { value = integer<std::uint32_t>(0, 0xFFFFFFFFU); }
  void operator()(std::int32_t& value) {
    value =
        integer(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max());
    if (fill_ == Fill::kAnything && below(2) == 0) {
      value = -1 - value;
    }
  }
  void operator()(float& value) {
    using Limits = std::numeric_limits<float>;
    const float special[] = {0.0F,
                             -0.0F,
                             Limits::denorm_min(),
                             Limits::min(),
                             Limits::max(),
                             Limits::lowest(),
                             Limits::infinity(),
                             50.0F};
    switch (fill_) {
      case Fill::kLowest:
        value = -Limits::infinity();
        break;
      case Fill::kHighest:
        value = Limits::infinity();
        break;
      case Fill::kNaN:
        value = float_of(0xFFA5A5A5U);
        break;
      case Fill::kLongest:
      case Fill::kAnything:
        value = below(2) == 0 ? special[below(8)] : float_of(static_cast<std::uint32_t>(random_()));
        break;
    }
  }
  template <std::size_t N>
  void operator()(char (&text)[N]) {
    std::size_t length = fill_ == Fill::kLowest ? 0 : N - 1;
    if (fill_ == Fill::kAnything) {
      length = below(N);
    }
    for (std::size_t i = 0; i < length; ++i) {
      text[i] = static_cast<char>(' ' + below(95));
    }
    text[length] = '\0';
  }
  template <class E>
  void choice(E& value, E last, E first = E{}) {
    const auto low = static_cast<std::uint8_t>(first);
    const auto high = static_cast<std::uint8_t>(last);
    value = static_cast<E>(fill_ == Fill::kAnything
                               ? low + below(static_cast<std::uint32_t>(high - low + 1))
                               : integer(low, high));
  }
  void settings(Downlink& message) { outlet::visit_fields(message.settings, *this); }
  template <class T>
  void operator()(const outlet::Field&, T& value) {
    (*this)(value);
  }
  void rows(const outlet::Field&, outlet::ConditionRow* rows, std::uint8_t& count) {
    constexpr std::uint8_t kMost = outlet::kMaxConditions;
    count = static_cast<std::uint8_t>(fill_ == Fill::kAnything ? below(kMost + 1U)
                                                               : integer(std::uint8_t{0}, kMost));
    for (int row = 0; row < count; ++row) {
      (*this)(rows[row].from_hz);
      (*this)(rows[row].rocof_below_hz_s);
    }
  }

 private:
  Fill fill_;
  std::mt19937& random_;
};

// Moves values into the ranges of a hello's fields.
void make_valid(Hello& hello) {
  for (char* at = hello.id; *at != '\0'; ++at) {
    *at = static_cast<char>('a' + static_cast<unsigned char>(*at) % 26);
  }
  if (hello.id[0] == '\0') {
    hello.id[0] = '-';
  }
  hello.sample_rate_hz = 1000 + (hello.sample_rate_hz & 0x7FFFFFFF) % 999001;
  hello.nominal_hz = hello.nominal_hz % 2 == 0 ? 50 : 60;
  for (float* const delay_s : {&hello.tracker_delay_s, &hello.voltage_delay_s}) {
    *delay_s = *delay_s >= 0.0F ? std::fmin(*delay_s, 1.0F) : 0.5F;
  }
}

// Fixes protocol_version, the only 16-bit field: a hello of another version has no further fields.
class HelloFiller : public Filler {
 public:
  using Filler::Filler;
  using Filler::operator();
  void operator()(std::uint16_t& protocol_version) { protocol_version = kProtocolVersion; }
};

constexpr Fill kFixedFills[] = {Fill::kLowest, Fill::kHighest, Fill::kLongest, Fill::kNaN};

// Result of encode() as a vector.
template <class Encode>
Bytes bytes_from(Encode encode, std::size_t capacity) {
  Bytes bytes(capacity);
  bytes.resize(encode(bytes.data(), bytes.size()));
  return bytes;
}

template <class Message, class Kind, class Make>
std::vector<Message> many(const std::vector<Kind>& kinds, int times, Make make) {
  std::mt19937 random(1);
  std::vector<Message> all;
  for (const Kind kind : kinds) {
    for (const Fill fill : kFixedFills) {
      all.push_back(make(kind, fill, random));
    }
    for (int i = 0; i < times; ++i) {
      all.push_back(make(kind, Fill::kAnything, random));
    }
  }
  return all;
}

template <class Kind>
std::vector<Kind> kinds_up_to(Kind last) {
  std::vector<Kind> all;
  for (int kind = 1; kind <= static_cast<int>(last); ++kind) {
    all.push_back(static_cast<Kind>(kind));
  }
  return all;
}

}  // namespace

bool operator==(const Field& a, const Field& b) {
  return a.type == b.type && a.number == b.number && a.text == b.text;
}

void PrintTo(const Field& field, std::ostream* out) {
  constexpr const char* kTypes[] = {"integer", "float of bits", "boolean", "text", "map", "array"};
  *out << kTypes[static_cast<std::size_t>(field.type)] << ' ' << field.number << ' ' << field.text;
}

std::vector<Field> fields_of(const Uplink& message) {
  Collector collector;
  uplink_fields(message, collector);
  return collector.fields;
}

std::vector<Field> fields_of(const Downlink& message) {
  Collector collector;
  downlink_fields(message, collector);
  return collector.fields;
}

std::vector<Field> fields_of(const outlet::Settings& settings) {
  Collector collector;
  collector.settings(settings);
  return collector.fields;
}

Uplink uplink(UplinkKind kind, Fill fill, std::mt19937& random) {
  Uplink message;
  message.kind = kind;
  Filler filler(fill, random);
  const std::uint64_t high = filler.integer<std::uint32_t>(0, 0xFFFFFFFFU);
  message.sample = high << 32 | filler.integer<std::uint32_t>(0, 0xFFFFFFFFU);
  message.start_number = filler.integer<std::uint32_t>(0, 0xFFFFFFFFU);
  if (kind == UplinkKind::kHello) {
    HelloFiller hello(fill, random);
    uplink_fields(message, hello);
    make_valid(message.hello);
  } else {
    uplink_fields(message, filler);
  }
  return message;
}

Downlink downlink(DownlinkKind kind, Fill fill, std::mt19937& random) {
  Downlink message;
  message.kind = kind;
  Filler filler(fill, random);
  message.session = filler.integer<std::uint32_t>(1, 0xFFFFFFFFU);
  message.session += message.session == kNoSession ? 1 : 0;
  downlink_fields(message, filler);
  message.request += kind == DownlinkKind::kCommand && message.request == 0 ? 1 : 0;
  return message;
}

std::vector<UplinkKind> uplink_kinds() {
  return kinds_up_to(kLastUplink);
}

std::vector<DownlinkKind> downlink_kinds() {
  return kinds_up_to(kLastDownlink);
}

std::vector<Uplink> many_uplinks(int times) {
  return many<Uplink>(uplink_kinds(), times, uplink);
}

std::vector<Downlink> many_downlinks(int times) {
  return many<Downlink>(downlink_kinds(), times, downlink);
}

Bytes encoded(const Uplink& message, std::uint32_t sequence) {
  return bytes_from([&](auto* out, auto size) { return encode(message, sequence, out, size); },
                    kLongestMessage);
}

Bytes encoded(const Downlink& message, std::uint32_t sequence) {
  return bytes_from([&](auto* out, auto size) { return encode(message, sequence, out, size); },
                    kLongestMessage);
}

Bytes encoded(const outlet::Settings& settings) {
  return bytes_from([&](auto* out, auto size) { return encode(settings, out, size); },
                    kLongestMessage);
}

Bytes framed(const Bytes& message) {
  return bytes_from(
      [&](auto* out, auto size) { return frame(message.data(), message.size(), out, size); },
      kLongestFrame);
}

std::vector<Bytes> frames_in(FrameReader& reader, const Bytes& stream) {
  std::vector<Bytes> found;
  for (const std::uint8_t byte : stream) {
    const FrameReader::Taken taken = reader.take(byte);
    if (taken == FrameReader::Taken::kMessage) {
      found.emplace_back(reader.message(), reader.message() + reader.size());
    } else if (taken == FrameReader::Taken::kBadFrame) {
      found.emplace_back();
    }
  }
  return found;
}

std::string hex(const Bytes& bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) {
    if (!text.empty()) {
      text += ' ';
    }
    text += kDigits[byte >> 4];
    text += kDigits[byte & 0xF];
  }
  return text;
}

}  // namespace gs::wire::test

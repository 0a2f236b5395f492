#include <type_traits>

#include <outlet/settings.hpp>
#include <wire/cbor.hpp>
#include <wire/codec.hpp>
#include <wire/fields.hpp>

namespace gs::wire {
namespace {

struct Counter {
  std::size_t items = 0;

  template <class T>
  void operator()(const T&) {
    ++items;
  }
  template <class E>
  void choice(const E&, E, E = E{}) {
    ++items;
  }
  void settings(const Downlink&) { ++items; }
};

constexpr std::size_t kSettingsFieldCount =
    sizeof outlet::kSettingsFields / sizeof outlet::kSettingsFields[0];

// Key and value of each setting.
struct SettingsEncoder {
  cbor::Writer& writer;

  void operator()(const outlet::Field& field, const float& value) {
    writer.unsigned_integer(field.key);
    writer.single(value);
  }
  template <class T>
  void operator()(const outlet::Field& field, const T& value) {
    writer.unsigned_integer(field.key);
    writer.unsigned_integer(value);
  }
  void rows(const outlet::Field& field, const outlet::ConditionRow* rows, std::uint8_t count) {
    const int most = count < outlet::kMaxConditions ? count : outlet::kMaxConditions;
    writer.unsigned_integer(field.key);
    writer.array(2 * static_cast<std::size_t>(most));
    for (int row = 0; row < most; ++row) {
      writer.single(rows[row].from_hz);
      writer.single(rows[row].rocof_below_hz_s);
    }
  }
};

void write_settings(cbor::Writer& writer, const outlet::Settings& settings) {
  writer.map(kSettingsFieldCount);
  SettingsEncoder encoder{writer};
  outlet::visit_fields(settings, encoder);
}

template <class T>
bool read_number(cbor::Reader& reader, T& value) {
  std::uint64_t wide = 0;
  const bool ok = reader.unsigned_integer(wide) && wide <= static_cast<T>(-1);
  value = ok ? static_cast<T>(wide) : value;
  return ok;
}

// The value of the setting whose key has just been read.
struct SettingsDecoder {
  cbor::Reader& reader;
  bool ok = true;

  void operator()(const outlet::Field&, float& value) { ok = reader.single(value); }
  template <class T>
  void operator()(const outlet::Field&, T& value) {
    ok = read_number(reader, value);
  }
  void rows(const outlet::Field&, outlet::ConditionRow* rows, std::uint8_t& count) {
    std::size_t items = 0;
    ok = reader.array(items) && items % 2 == 0 && items <= 2 * outlet::kMaxConditions;
    count = static_cast<std::uint8_t>(ok ? items / 2 : 0);
    for (int row = 0; ok && row < count; ++row) {
      ok = reader.single(rows[row].from_hz) && reader.single(rows[row].rocof_below_hz_s);
    }
  }
};

// Keys missing from the map have their defaults. `unknown` is set if a key is not a known setting.
bool read_settings(cbor::Reader& reader, outlet::Settings& settings, bool& unknown) {
  static_assert(kSettingsFieldCount <= 64, "one bit each");
  std::size_t pairs = 0;
  if (!reader.map(pairs)) {
    return false;
  }
  settings = outlet::Settings{};
  unknown = false;
  std::uint64_t seen = 0;
  for (; pairs > 0; --pairs) {
    std::uint64_t key = 0;
    if (!reader.unsigned_integer(key)) {
      return false;
    }
    std::size_t at = 0;
    while (at < kSettingsFieldCount && outlet::kSettingsFields[at].key != key) {
      ++at;
    }
    if (at == kSettingsFieldCount) {
      unknown = true;
      if (!reader.skip()) {
        return false;
      }
      continue;
    }
    SettingsDecoder decoder{reader};
    outlet::visit_field(settings, outlet::kSettingsFields[at], decoder);
    if (!decoder.ok || (seen >> at & 1u) != 0) {
      return false;
    }
    seen |= std::uint64_t{1} << at;
  }
  return true;
}

struct Encoder {
  cbor::Writer& writer;

  void operator()(bool value) { writer.boolean(value); }
  void operator()(float value) { writer.single(value); }
  void operator()(std::int32_t value) { writer.integer(value); }
  template <class T>
  void operator()(T value) {
    static_assert(std::is_unsigned_v<T>);
    writer.unsigned_integer(value);
  }
  template <std::size_t N>
  void operator()(const char (&text)[N]) {
    std::size_t length = 0;
    while (length < N - 1 && text[length] != '\0') {
      ++length;
    }
    writer.text(text, length);
  }
  template <class E>
  void choice(E value, E, E = E{}) {
    writer.unsigned_integer(static_cast<std::uint8_t>(value));
  }
  void settings(const Downlink& message) { write_settings(writer, message.settings); }
};

// Skips items added by a later version. Fails if bytes follow the array.
bool pass_over(cbor::Reader& reader, std::size_t items) {
  for (; items > 0; --items) {
    if (!reader.skip()) {
      return false;
    }
  }
  return reader.left() == 0;
}

// Stops reading at the first field that is missing, of another type or out of range.
struct Decoder {
  cbor::Reader& reader;
  std::size_t items;  // left of the array
  bool ok = true;

  void operator()(bool& value) { ok = next() && reader.boolean(value); }
  void operator()(float& value) { ok = next() && reader.single(value); }
  template <class T>
  void operator()(T& value) {
    static_assert(std::is_unsigned_v<T>);
    ok = next() && read_number(reader, value);
  }
  void operator()(std::int32_t& value) {
    std::int64_t wide = 0;
    ok = next() && reader.integer(wide) && wide >= INT32_MIN && wide <= INT32_MAX;
    value = ok ? static_cast<std::int32_t>(wide) : value;
  }
  template <std::size_t N>
  void operator()(char (&text)[N]) {
    ok = next() && reader.text(text, N - 1);
  }
  template <class E>
  void choice(E& value, E last, E first = E{}) {
    std::uint8_t raw = 0;
    (*this)(raw);
    ok = ok && raw >= static_cast<std::uint8_t>(first) && raw <= static_cast<std::uint8_t>(last);
    value = ok ? static_cast<E>(raw) : value;
  }
  void settings(Downlink& message) {
    bool unknown = false;
    ok = next() && read_settings(reader, message.settings, unknown);
    if (unknown) {
      message.settings_error = outlet::SettingsError::kUnknownField;
    }
  }

  bool next() {
    if (!ok || items == 0) {
      return false;
    }
    --items;
    return true;
  }

  bool finish() { return ok && pass_over(reader, items); }
};

std::size_t finished(const cbor::Writer& writer) {
  return writer.ok() ? writer.size() : 0;
}

// `M`: the message type, or its const form.
template <class M, class V>
void head(M& message, V& visit) {
  if constexpr (std::is_same_v<std::remove_const_t<M>, Uplink>) {
    uplink_head(message, visit);
  } else {
    downlink_head(message, visit);
  }
}

template <class M, class V>
void fields(M& message, V& visit) {
  if constexpr (std::is_same_v<std::remove_const_t<M>, Uplink>) {
    uplink_fields(message, visit);
  } else {
    downlink_fields(message, visit);
  }
}

// Ranges that the types do not have.
bool in_range(const Uplink& message) {
  return message.kind != UplinkKind::kHello || is_valid(message.hello);
}

bool in_range(const Downlink& message) {
  return message.kind != DownlinkKind::kCommand || message.request > 0;
}

bool has_session(const Uplink&) {
  return true;
}

bool has_session(const Downlink& message) {
  return message.session != kNoSession;
}

template <class M>
std::size_t encode_message(const M& message, std::uint32_t sequence, std::uint8_t* out,
                           std::size_t capacity) {
  Counter counter;
  head(message, counter);
  fields(message, counter);
  cbor::Writer writer(out, capacity);
  writer.array(2 + counter.items);
  writer.unsigned_integer(static_cast<std::uint8_t>(message.kind));
  writer.unsigned_integer(sequence);
  Encoder encoder{writer};
  head(message, encoder);
  fields(message, encoder);
  return finished(writer);
}

template <class M>
Decoded decode_message(const std::uint8_t* bytes, std::size_t size, decltype(M::kind) last_kind,
                       M& message, std::uint32_t& sequence) {
  cbor::Reader reader(bytes, size);
  std::size_t items = 0;
  std::uint64_t kind = 0;
  if (size > kLongestMessage || !reader.array(items) || items < 2 ||
      !reader.unsigned_integer(kind) || !read_number(reader, sequence)) {
    return Decoded::kMalformed;
  }
  const bool known = kind > 0 && kind <= static_cast<std::uint64_t>(last_kind);
  message = M{};
  // Any kind but hello has the usual head.
  message.kind = known ? static_cast<decltype(M::kind)>(kind) : last_kind;
  Decoder decoder{reader, items - 2};
  head(message, decoder);
  if (known) {
    fields(message, decoder);
  }
  if (!decoder.finish() || !has_session(message) || (known && !in_range(message))) {
    return Decoded::kMalformed;
  }
  return known ? Decoded::kOk : Decoded::kUnknownKind;
}

}  // namespace

std::size_t encode(const Uplink& message, std::uint32_t sequence, std::uint8_t* out,
                   std::size_t capacity) {
  return encode_message(message, sequence, out, capacity);
}

std::size_t encode(const Downlink& message, std::uint32_t sequence, std::uint8_t* out,
                   std::size_t capacity) {
  return encode_message(message, sequence, out, capacity);
}

std::size_t encode(const outlet::Settings& settings, std::uint8_t* out, std::size_t capacity) {
  cbor::Writer writer(out, capacity);
  write_settings(writer, settings);
  return finished(writer);
}

Decoded decode(const std::uint8_t* bytes, std::size_t size, Uplink& message,
               std::uint32_t& sequence) {
  return decode_message(bytes, size, kLastUplink, message, sequence);
}

Decoded decode(const std::uint8_t* bytes, std::size_t size, Downlink& message,
               std::uint32_t& sequence) {
  return decode_message(bytes, size, kLastDownlink, message, sequence);
}

Decoded decode(const std::uint8_t* bytes, std::size_t size, outlet::Settings& settings) {
  cbor::Reader reader(bytes, size);
  bool unknown = false;
  return read_settings(reader, settings, unknown) && !unknown && reader.left() == 0
             ? Decoded::kOk
             : Decoded::kMalformed;
}

}  // namespace gs::wire

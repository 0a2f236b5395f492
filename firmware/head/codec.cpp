#include <type_traits>

#include <head/codec.hpp>
#include <head/fields.hpp>

namespace gs::head {
namespace {

// Writes fields while they fit.
class FieldWriter {
 public:
  FieldWriter(std::uint8_t* out, std::size_t capacity) : out_(out), capacity_(capacity) {}

  template <class Integer>
  void operator()(const Integer& value) {
    static_assert(std::is_integral_v<Integer>);
    const auto bits = static_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < sizeof(Integer); ++i) {
      put(static_cast<std::uint8_t>(bits >> (8 * i)));
    }
  }
  void operator()(const char (&text)[kBoardBytes + 1]) {
    for (std::size_t i = 0; i < kBoardBytes; ++i) {
      put(static_cast<std::uint8_t>(text[i]));
    }
  }
  void operator()(const std::uint8_t (&bytes)[kUniqueIdBytes]) {
    for (const std::uint8_t byte : bytes) {
      put(byte);
    }
  }
  template <class Enum>
  void choice(const Enum& value, Enum last, Enum first = Enum{}) {
    ok_ = ok_ && value >= first && value <= last;
    put(static_cast<std::uint8_t>(value));
  }
  void samples(const std::int16_t (&samples)[kLongestSamples], std::uint16_t count) {
    ok_ = ok_ && count >= 1 && count <= kLongestSamples;
    for (std::size_t i = 0; ok_ && i < count; ++i) {
      (*this)(samples[i]);
    }
  }

  std::size_t size() const { return ok_ ? size_ : 0; }

 private:
  void put(std::uint8_t byte) {
    ok_ = ok_ && size_ < capacity_;
    if (ok_) {
      out_[size_++] = byte;
    }
  }

  std::uint8_t* out_;
  std::size_t capacity_;
  std::size_t size_ = 0;
  bool ok_ = true;
};

class FieldReader {
 public:
  FieldReader(const std::uint8_t* bytes, std::size_t size) : at_(bytes), end_(bytes + size) {}

  template <class Integer>
  void operator()(Integer& value) {
    static_assert(std::is_integral_v<Integer>);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Integer); ++i) {
      bits |= std::uint64_t{next()} << (8 * i);
    }
    value = static_cast<Integer>(bits);
  }
  void operator()(bool& value) {
    const std::uint8_t byte = next();
    ok_ = ok_ && byte <= 1;
    value = byte == 1;
  }
  // Printable ASCII, then zeros.
  void operator()(char (&text)[kBoardBytes + 1]) {
    bool ended = false;
    for (std::size_t i = 0; i < kBoardBytes; ++i) {
      const std::uint8_t byte = next();
      ended = ended || byte == 0;
      ok_ = ok_ && (ended ? byte == 0 : byte >= 0x20 && byte <= 0x7E);
      text[i] = static_cast<char>(byte);
    }
    text[kBoardBytes] = '\0';
  }
  void operator()(std::uint8_t (&bytes)[kUniqueIdBytes]) {
    for (std::uint8_t& byte : bytes) {
      byte = next();
    }
  }
  template <class Enum>
  void choice(Enum& value, Enum last, Enum first = Enum{}) {
    const std::uint8_t byte = next();
    ok_ =
        ok_ && byte >= static_cast<std::uint8_t>(first) && byte <= static_cast<std::uint8_t>(last);
    value = static_cast<Enum>(byte);
  }
  void samples(std::int16_t (&samples)[kLongestSamples], std::uint16_t count) {
    ok_ = ok_ && count >= 1 && count <= kLongestSamples;
    for (std::size_t i = 0; ok_ && i < count; ++i) {
      (*this)(samples[i]);
    }
  }

  bool ok() const { return ok_; }
  bool at_end() const { return at_ == end_; }

 private:
  std::uint8_t next() {
    ok_ = ok_ && at_ != end_;
    return ok_ ? *at_++ : std::uint8_t{0};
  }

  const std::uint8_t* at_;
  const std::uint8_t* end_;
  bool ok_ = true;
};

// Other versions may have more fields.
template <class Message>
bool is_open_ended(const Message& message) {
  if constexpr (Message::kKind == Kind::kIdentify || Message::kKind == Kind::kHello) {
    return message.protocol_version != kProtocolVersion;
  } else {
    static_cast<void>(message);
    return false;
  }
}

}  // namespace

bool decode_header(const std::uint8_t* bytes, std::size_t size, Header& header) {
  FieldReader reader(bytes, size);
  std::uint8_t kind = 0;
  reader(kind);
  reader(header.number);
  header.kind = static_cast<Kind>(kind);
  return reader.ok();
}

template <class Message>
std::size_t encode(const Message& message, std::uint32_t number, std::uint8_t* out,
                   std::size_t capacity) {
  FieldWriter writer(out, capacity);
  writer(static_cast<std::uint8_t>(Message::kKind));
  writer(number);
  fields(message, writer);
  return writer.size();
}

template <class Message>
bool decode(const std::uint8_t* bytes, std::size_t size, Message& message) {
  Header header;
  if (!decode_header(bytes, size, header) || header.kind != Message::kKind) {
    return false;
  }
  FieldReader reader(bytes + kHeadLength, size - kHeadLength);
  fields(message, reader);
  return reader.ok() && (reader.at_end() || is_open_ended(message));
}

template std::size_t encode(const Identify&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const Arm&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const Samples&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const Play&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const Stop&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const Ping&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const ResendEdges&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const Hello&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const Status&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const Edge&, std::uint32_t, std::uint8_t*, std::size_t);
template std::size_t encode(const Refused&, std::uint32_t, std::uint8_t*, std::size_t);

template bool decode(const std::uint8_t*, std::size_t, Identify&);
template bool decode(const std::uint8_t*, std::size_t, Arm&);
template bool decode(const std::uint8_t*, std::size_t, Samples&);
template bool decode(const std::uint8_t*, std::size_t, Play&);
template bool decode(const std::uint8_t*, std::size_t, Stop&);
template bool decode(const std::uint8_t*, std::size_t, Ping&);
template bool decode(const std::uint8_t*, std::size_t, ResendEdges&);
template bool decode(const std::uint8_t*, std::size_t, Hello&);
template bool decode(const std::uint8_t*, std::size_t, Status&);
template bool decode(const std::uint8_t*, std::size_t, Edge&);
template bool decode(const std::uint8_t*, std::size_t, Refused&);

}  // namespace gs::head

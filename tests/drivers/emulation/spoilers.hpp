// Spoilers for a cable (emulation/null_modem.hpp). Some decode frames, and change, drop or repeat
// whole messages; the others damage single bytes.
#pragma once

#include <wire_test/messages.hpp>

#include <functional>
#include <memory>
#include <ostream>
#include <utility>
#include <vector>

#include <emulation/null_modem.hpp>

namespace gsbench::test {

using gs::wire::test::Bytes;

// `change` gets each whole message and returns the messages to pass instead.
inline emulation::Spoiler each_message(std::function<std::vector<Bytes>(const Bytes&)> change) {
  auto reader = std::make_shared<gs::wire::FrameReader>();
  return [reader, change = std::move(change)](Bytes& bytes) {
    const Bytes came = std::exchange(bytes, {});
    for (const Bytes& message : gs::wire::test::frames_in(*reader, came)) {
      if (message.empty()) {
        continue;  // a bad frame
      }
      for (const Bytes& changed : change(message)) {
        const Bytes frame = gs::wire::test::framed(changed);
        bytes.insert(bytes.end(), frame.begin(), frame.end());
      }
    }
  };
}

// Changes the outlet's hellos.
inline emulation::Spoiler change_hello(std::function<void(gs::wire::Hello&)> change) {
  return each_message([change = std::move(change)](const Bytes& message) -> std::vector<Bytes> {
    gs::wire::Uplink uplink;
    std::uint32_t sequence = 0;
    if (gs::wire::decode(message.data(), message.size(), uplink, sequence) !=
            gs::wire::Decoded::kOk ||
        uplink.kind != gs::wire::UplinkKind::kHello) {
      return {message};
    }
    change(uplink.hello);
    return {gs::wire::test::encoded(uplink, sequence)};
  });
}

// Calls `spoil` at every n-th byte with all bytes up to it; `spoil` may change, drop or add bytes
// at the end.
inline emulation::Spoiler every_nth_byte(std::size_t n, std::function<void(Bytes& until)> spoil) {
  auto passed = std::make_shared<std::size_t>(0);
  return [passed, n, spoil = std::move(spoil)](Bytes& bytes) {
    Bytes out;
    for (const std::uint8_t byte : bytes) {
      out.push_back(byte);
      if (++*passed % n == 0) {
        spoil(out);
      }
    }
    bytes = out;
  };
}

inline void flip_a_bit(Bytes& bytes) {
  bytes.back() ^= 0x10;
}
inline void drop_a_byte(Bytes& bytes) {
  bytes.pop_back();
}
// A zero is not doubled: the result would be an empty frame, which is ignored.
inline void double_a_byte(Bytes& bytes) {
  bytes.push_back(bytes.back() == 0 ? 1 : bytes.back());
}
inline void reorder_two_bytes(Bytes& bytes) {
  if (bytes.size() > 1) {
    std::swap(bytes.back(), bytes[bytes.size() - 2]);
  }
}

struct Spoiling {
  const char* name;
  void (*spoil)(Bytes& bytes);
};

inline void PrintTo(const Spoiling& spoiling, std::ostream* out) {
  *out << spoiling.name;
}

constexpr Spoiling kSpoilings[] = {{"FlippedBits", flip_a_bit},
                                   {"DroppedBytes", drop_a_byte},
                                   {"DoubledBytes", double_a_byte},
                                   {"ReorderedBytes", reorder_two_bytes}};

}  // namespace gsbench::test

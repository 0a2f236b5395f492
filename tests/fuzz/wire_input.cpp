#include "wire_input.hpp"

#include "flash_cells.hpp"
#include <settings_storage/settings_storage.hpp>
#include <wire_test/messages.hpp>

#include <algorithm>

#include <app/endpoint.hpp>
#include <wire/codec.hpp>
#include <wire/frame.hpp>

namespace gsbench::fuzz {
namespace {

using gs::wire::Decoded;
using gs::wire::FrameReader;
using gs::wire::kLongestFrame;
using gs::wire::kLongestMessage;
using gs::wire::test::Bytes;
using gs::wire::test::encoded;
using gs::wire::test::fields_of;
using gs::wire::test::framed;

// What the outlet says, read as the bench would.
class Listener final : public gs::app::Carrier {
 public:
  bool send(const std::uint8_t* bytes, std::size_t size) override {
    gs::wire::Uplink message;
    std::uint32_t sequence = 0;
    unreadable_ = unreadable_ || gs::wire::decode(bytes, size, message, sequence) != Decoded::kOk;
    ++said_;
    return true;
  }
  bool unreadable() const { return unreadable_; }
  int said() const { return said_; }

 private:
  bool unreadable_ = false;
  int said_ = 0;
};

bool is_settings(const gs::wire::Uplink&) {
  return false;
}
bool is_settings(const gs::wire::Downlink& message) {
  return message.kind == gs::wire::DownlinkKind::kSettings;
}

// Message: Uplink or Downlink.
template <class Message>
std::string wrong_with_decoded(const std::uint8_t* bytes, std::size_t size) {
  Message message;
  std::uint32_t sequence = 0;
  if (gs::wire::decode(bytes, size, message, sequence) != Decoded::kOk) {
    return "";
  }
  const Bytes once = encoded(message, sequence);
  if (once.empty()) {
    return "a message that was read cannot be written";
  }
  // Settings that were left out are written with their defaults.
  if (once.size() > size && !is_settings(message)) {
    return "written longer than it was read";
  }
  Message again;
  std::uint32_t again_sequence = 0;
  if (gs::wire::decode(once.data(), once.size(), again, again_sequence) != Decoded::kOk) {
    return "what was written cannot be read";
  }
  if (again_sequence != sequence || again.kind != message.kind ||
      !(fields_of(again) == fields_of(message)) || encoded(again, sequence) != once) {
    return "read again, it is another message";
  }
  return "";
}

std::string wrong_with_outlet(const std::uint8_t* bytes, std::size_t size) {
  Listener listener;
  gs::app::Application app;
  gs::app::MessageEndpoint endpoint(app, listener);
  if (!app.start(gs::outlet::Hardware{}, {}, nullptr, endpoint)) {
    return "the outlet did not start";
  }
  endpoint.receive(bytes, size);
  if (listener.unreadable()) {
    return "the outlet said what cannot be read";
  }
  if (listener.said() < 2) {
    return "the outlet left a message without an answer";
  }
  constexpr std::int16_t kSamples[256] = {};
  app.feed(kSamples, 256, endpoint);
  return app.samples_taken() == 256 ? "" : "the outlet stopped";
}

std::string wrong_with_framing(const Bytes& message) {
  const Bytes frame = framed(message);
  if (frame.empty()) {
    return "a message is not framed";
  }
  if (frame.size() > kLongestFrame) {
    return "a frame longer than the longest";
  }
  if (std::count(frame.begin(), frame.end(), 0) != 2) {
    return "a zero within a frame";
  }
  return "";
}

}  // namespace

std::string wrong_with_stream(const std::uint8_t* bytes, std::size_t size) {
  FrameReader reader;
  std::size_t zeros = 0;
  std::size_t ended = 0;
  for (std::size_t i = 0; i < size; ++i) {
    zeros += bytes[i] == 0 ? 1 : 0;
    const FrameReader::Taken taken = reader.take(bytes[i]);
    ended += taken != FrameReader::Taken::kNothing ? 1 : 0;
    if (taken != FrameReader::Taken::kMessage) {
      continue;
    }
    if (reader.size() == 0 || reader.size() > kLongestMessage) {
      return "a message of no such length";
    }
    std::string wrong = wrong_with_framing({reader.message(), reader.message() + reader.size()});
    if (!wrong.empty()) {
      return wrong;
    }
  }
  if (ended > zeros) {
    return "more frames than zeros";
  }
  if (size == 0) {
    return "";
  }
  // The input as a message, behind itself as junk.
  const Bytes message(bytes, bytes + std::min(size, kLongestMessage));
  std::string wrong = wrong_with_framing(message);
  if (!wrong.empty()) {
    return wrong;
  }
  FrameReader::Taken last = FrameReader::Taken::kNothing;
  for (const std::uint8_t byte : framed(message)) {
    last = reader.take(byte);
  }
  const bool found = last == FrameReader::Taken::kMessage && reader.size() == message.size() &&
                     std::equal(message.begin(), message.end(), reader.message());
  return found ? "" : "a frame behind junk is not found";
}

std::string wrong_with_message(const std::uint8_t* bytes, std::size_t size) {
  std::string wrong = wrong_with_decoded<gs::wire::Uplink>(bytes, size);
  if (wrong.empty()) {
    wrong = wrong_with_decoded<gs::wire::Downlink>(bytes, size);
  }
  if (wrong.empty()) {
    wrong = wrong_with_outlet(bytes, size);
  }
  return wrong;
}

std::string wrong_with_settings(const std::uint8_t* bytes, std::size_t size) {
  gs::outlet::Settings settings;
  if (gs::wire::decode(bytes, size, settings) != Decoded::kOk) {
    return "";
  }
  const Bytes once = encoded(settings);
  if (once.empty()) {
    return "settings that were read cannot be written";
  }
  gs::outlet::Settings again;
  if (gs::wire::decode(once.data(), once.size(), again) != Decoded::kOk) {
    return "what was written cannot be read";
  }
  if (encoded(again) != once) {
    return "read again, they are others";
  }
  constexpr float kNominal_hz = 50.0F;
  if (gs::outlet::validate(settings, kNominal_hz) != gs::outlet::SettingsError::kNone) {
    return "";
  }
  if (gs::outlet::digest(again) != gs::outlet::digest(settings)) {
    return "another digest";
  }
  Listener listener;
  gs::app::Application app;
  gs::app::MessageEndpoint endpoint(app, listener);
  if (!app.start(gs::outlet::Hardware{}, {}, nullptr, endpoint)) {
    return "the outlet did not start";
  }
  // Version 0 stands for none.
  const bool can_be_in_force = settings.version != gs::outlet::kNoSettings;
  if (app.restore(settings) != can_be_in_force) {
    return can_be_in_force ? "valid settings are not restored" : "settings of no version are";
  }
  std::int16_t samples[2048] = {};
  for (std::size_t i = 0; i < 2048; ++i) {
    samples[i] = static_cast<std::int16_t>(i / 80 % 2 == 0 ? 9000 : -9000);
  }
  app.feed(samples, 2048, endpoint);
  return listener.unreadable() ? "the outlet said what cannot be read" : "";
}

std::string wrong_with_flash(const std::uint8_t* bytes, std::size_t size) {
  FlashCells flash({bytes, bytes + size});
  gs::settings_storage::FlashSettingsStorage area(flash);
  gs::outlet::Settings settings;
  if (area.load(settings)) {
    const Bytes kept = encoded(settings);
    if (kept.empty()) {
      return "settings were loaded that cannot be written";
    }
    if (!area.usable()) {
      return "settings were loaded from an area that is not usable";
    }
    gs::outlet::Settings again;
    if (!area.load(again) || encoded(again) != kept) {
      return "loaded again, they are others";
    }
  }
  settings = {};
  settings.version = 12345;
  if (!area.keep(settings)) {
    return "settings cannot be kept behind what was there";
  }
  gs::outlet::Settings back;
  if (!area.load(back) || encoded(back) != encoded(settings)) {
    return "what was kept is not loaded";
  }
  return flash.misused() ? "the flash was used as it must not be" : "";
}

}  // namespace gsbench::fuzz

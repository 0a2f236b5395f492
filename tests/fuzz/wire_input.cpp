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

// Decodes the outlet's messages as the bench does.
class Listener final : public gs::app::Carrier {
 public:
  bool send(const std::uint8_t* bytes, std::size_t size) override {
    gs::wire::Uplink message;
    std::uint32_t sequence = 0;
    unreadable_ = unreadable_ || gs::wire::decode(bytes, size, message, sequence) != Decoded::kOk;
    ++messages_;
    return true;
  }
  bool unreadable() const { return unreadable_; }
  int messages() const { return messages_; }

 private:
  bool unreadable_ = false;
  int messages_ = 0;
};

gs::app::Identity test_identity() {
  gs::app::Identity identity;
  gs::app::set_text(identity.id, "fuzzed");
  return identity;
}

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
    return "a decoded message cannot be encoded";
  }
  // Omitted settings are encoded with their defaults.
  if (once.size() > size && !is_settings(message)) {
    return "the encoded message is longer than the input";
  }
  Message again;
  std::uint32_t again_sequence = 0;
  if (gs::wire::decode(once.data(), once.size(), again, again_sequence) != Decoded::kOk) {
    return "the encoded message cannot be decoded";
  }
  if (again_sequence != sequence || again.kind != message.kind ||
      !(fields_of(again) == fields_of(message)) || encoded(again, sequence) != once) {
    return "the message differs after encoding and decoding";
  }
  return "";
}

std::string wrong_with_outlet(const std::uint8_t* bytes, std::size_t size) {
  Listener listener;
  gs::app::Application app;
  gs::app::MessageEndpoint endpoint(app, listener);
  if (!app.start(gs::outlet::Hardware{}, test_identity(), nullptr, endpoint)) {
    return "the outlet did not start";
  }
  endpoint.receive(bytes, size);
  if (listener.unreadable()) {
    return "a message of the outlet cannot be decoded";
  }
  if (listener.messages() < 2) {
    return "the outlet did not answer a message";
  }
  constexpr std::int16_t kSamples[256] = {};
  app.feed(kSamples, 256, endpoint);
  return app.samples_taken() == 256 ? "" : "the outlet stopped processing samples";
}

std::string wrong_with_framing(const Bytes& message) {
  const Bytes frame = framed(message);
  if (frame.empty()) {
    return "a message cannot be framed";
  }
  if (frame.size() > kLongestFrame) {
    return "a frame exceeds the maximum length";
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
      return "a message has an invalid length";
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
  // The input as a message in a frame, after the same input as garbage.
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
  return found ? "" : "a frame after garbage is not found";
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
    return "decoded settings cannot be encoded";
  }
  gs::outlet::Settings again;
  if (gs::wire::decode(once.data(), once.size(), again) != Decoded::kOk) {
    return "the encoded message cannot be decoded";
  }
  if (encoded(again) != once) {
    return "the settings differ after encoding and decoding";
  }
  constexpr float kNominal_hz = 50.0F;
  if (gs::outlet::validate(settings, kNominal_hz) != gs::outlet::SettingsError::kNone) {
    return "";
  }
  if (gs::outlet::digest(again) != gs::outlet::digest(settings)) {
    return "the digest differs after encoding and decoding";
  }
  Listener listener;
  gs::app::Application app;
  gs::app::MessageEndpoint endpoint(app, listener);
  if (!app.start(gs::outlet::Hardware{}, test_identity(), nullptr, endpoint)) {
    return "the outlet did not start";
  }
  // Version 0 means: no settings.
  const bool can_be_restored = settings.version != gs::outlet::kNoSettings;
  if (app.restore(settings) != can_be_restored) {
    return can_be_restored ? "valid settings are not restored"
                           : "settings of version 0 are restored";
  }
  std::int16_t samples[2048] = {};
  for (std::size_t i = 0; i < 2048; ++i) {
    samples[i] = static_cast<std::int16_t>(i / 80 % 2 == 0 ? 9000 : -9000);
  }
  app.feed(samples, 2048, endpoint);
  return listener.unreadable() ? "a message of the outlet cannot be decoded" : "";
}

std::string wrong_with_flash(const std::uint8_t* bytes, std::size_t size) {
  FlashCells flash({bytes, bytes + size});
  gs::settings_storage::FlashSettingsStorage storage(flash);
  gs::outlet::Settings settings;
  if (storage.load(settings)) {
    const Bytes kept = encoded(settings);
    if (kept.empty()) {
      return "loaded settings cannot be encoded";
    }
    if (!storage.usable()) {
      return "settings were loaded from a storage that is not usable";
    }
    gs::outlet::Settings again;
    if (!storage.load(again) || encoded(again) != kept) {
      return "the settings differ when loaded again";
    }
  }
  settings = {};
  settings.version = 12345;
  if (!storage.keep(settings)) {
    return "new settings cannot be stored after the previous contents";
  }
  gs::outlet::Settings back;
  if (!storage.load(back) || encoded(back) != encoded(settings)) {
    return "stored settings are not loaded";
  }
  return flash.misused() ? "the flash was accessed incorrectly" : "";
}

}  // namespace gsbench::fuzz

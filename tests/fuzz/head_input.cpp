// The DAC head under any messages. The input is a sequence of messages, each with its length in the
// two bytes before it.
#include "wire_input.hpp"
#include <head_test/rig.hpp>

#include <algorithm>

namespace gsbench::fuzz {
namespace {

using gs::head::Arm;
using gs::head::Edge;
using gs::head::Hello;
using gs::head::Identify;
using gs::head::Ping;
using gs::head::Play;
using gs::head::Refused;
using gs::head::ResendEdges;
using gs::head::Samples;
using gs::head::State;
using gs::head::Status;
using gs::head::Stop;
using gs::head::test::Bytes;
using gs::head::test::encoded;
using gs::head::test::Rig;
using gs::head::test::stream;

template <class Message>
bool is(const Bytes& bytes) {
  Message message;
  return decode(bytes.data(), bytes.size(), message);
}

template <class Message>
std::string wrong_with_encoding(const Bytes& bytes) {
  Message message;
  gs::head::Header header;
  if (!decode(bytes.data(), bytes.size(), message) ||
      !decode_header(bytes.data(), bytes.size(), header)) {
    return "";
  }
  const Bytes again = encoded(message, header.number);
  // Identify and hello of another version may have further bytes.
  const bool same = again.size() <= bytes.size() &&
                    std::equal(again.begin(), again.end(), bytes.begin()) && !again.empty();
  return same ? "" : "a decoded message has another encoding";
}

template <class... Message>
std::string wrong_with_encodings(const Bytes& bytes) {
  std::string wrong;
  ((wrong += wrong_with_encoding<Message>(bytes)), ...);
  return wrong;
}

// The head's answers are messages, and the codes are within the range of the DAC.
std::string wrong_with_output(const Rig& rig, State state, std::size_t first_code) {
  for (const Bytes& bytes : rig.received_bytes()) {
    if (!is<Hello>(bytes) && !is<Status>(bytes) && !is<Edge>(bytes) && !is<Refused>(bytes)) {
      return "a message of the head cannot be decoded";
    }
  }
  for (std::size_t i = first_code; i < rig.codes().size(); ++i) {
    if (rig.codes()[i] < 1 || rig.codes()[i] > 4095) {
      return "a code is beyond the range of the DAC";
    }
  }
  const bool silent = state == State::kOff || state == State::kFaulted;
  return silent && !rig.off_since(first_code) ? "the output is not off" : "";
}

// What a message that is not accepted must not change.
bool same(const Status& a, const Status& b) {
  return a.state == b.state && a.fault == b.fault && a.run == b.run && a.expected == b.expected &&
         a.position == b.position && a.room == b.room && a.edges == b.edges;
}

Status status_of(Rig rig) {
  return rig.status();
}

std::vector<std::uint16_t> next_codes_of(Rig rig) {
  const auto before = static_cast<std::ptrdiff_t>(rig.codes().size());
  rig.run_ms(2);
  return {rig.codes().begin() + before, rig.codes().end()};
}

// Gives the message to the head, and compares with a head that does not get it.
std::string wrong_with_one(Rig& rig, const Bytes& message) {
  const Rig without = rig;
  const std::size_t first_code = rig.codes().size();
  rig.send(message);
  const Status before = status_of(without);
  const Status after = status_of(rig);
  if (is<Identify>(message) || is<Stop>(message)) {
    if (after.state != State::kOff) {
      return "neither stop nor identify may fail";
    }
  } else if (after.expected == before.expected) {
    if (!same(before, after)) {
      return "a message that was not accepted has an effect";
    }
    if (!is<Ping>(message) && next_codes_of(rig) != next_codes_of(without)) {
      return "a message that was not accepted changes the output";
    }
  } else if (is<Samples>(message)) {
    Samples samples;
    static_cast<void>(decode(message.data(), message.size(), samples));
    if (before.room - after.room != samples.count) {
      return "accepted samples are not in the buffer";
    }
  } else if (!is<Arm>(message) && !is<Play>(message) && !is<ResendEdges>(message)) {
    return "a message of an unknown kind was accepted";
  }
  const State state = rig.head().state();
  rig.run_ms(1);
  std::string wrong = wrong_with_output(rig, state, first_code);
  rig.forget();
  return wrong;
}

// Off, armed, playing, faulted: a message meets each.
std::vector<Rig> rigs_in_all_states() {
  std::vector<Rig> rigs(4);
  rigs[0].send(Identify{});
  rigs[1].arm();
  rigs[2].play(512);
  rigs[2].run_ms(1);
  rigs[3].play(4);
  rigs[3].run_ms(1);
  for (Rig& rig : rigs) {
    rig.receive();
    rig.forget();
  }
  return rigs;
}

std::vector<Bytes> messages_in(const std::uint8_t* bytes, std::size_t size) {
  constexpr std::size_t kMost = 12;
  std::vector<Bytes> messages;
  for (std::size_t at = 0; at + 2 <= size && messages.size() < kMost;) {
    const std::size_t wanted = bytes[at] | std::size_t{bytes[at + 1]} << 8U;
    const std::size_t length = std::min(wanted, size - at - 2);
    messages.emplace_back(bytes + at + 2, bytes + at + 2 + length);
    at += 2 + length;
  }
  return messages;
}

std::string sequence_of(const std::vector<Bytes>& messages) {
  std::string text;
  for (const Bytes& message : messages) {
    text += static_cast<char>(message.size() % 256);
    text += static_cast<char>(message.size() / 256);
    text.append(message.begin(), message.end());
  }
  return text;
}

}  // namespace

std::string wrong_with_head(const std::uint8_t* bytes, std::size_t size) {
  static const std::vector<Rig> bases = rigs_in_all_states();
  const std::vector<Bytes> messages = messages_in(bytes, size);
  Rig rig;
  for (const Bytes& message : messages) {
    std::string wrong = wrong_with_encodings<Identify, Arm, Samples, Play, Stop, Ping, ResendEdges,
                                             Hello, Status, Edge, Refused>(message);
    if (wrong.empty()) {
      wrong = wrong_with_one(rig, message);
    }
    if (!wrong.empty()) {
      return wrong;
    }
  }
  for (std::size_t i = 0; !messages.empty() && i < bases.size(); ++i) {
    Rig base = bases[i];
    std::string wrong = wrong_with_one(base, messages.front());
    if (!wrong.empty()) {
      return wrong;
    }
  }
  return "";
}

std::vector<std::string> head_seeds() {
  const std::vector<Bytes> start = {encoded(Identify{}, 0), encoded(Arm{1}, 1),
                                    encoded(stream(0, 20), 2), encoded(Play{20}, 3)};
  std::vector<Bytes> run = start;
  run.insert(run.end(), {encoded(stream(20, 16), 4), encoded(Ping{9}, 5), encoded(Stop{}, 5),
                         encoded(Arm{2}, 6), encoded(ResendEdges{0}, 7)});
  std::vector<Bytes> gap = start;
  gap.insert(gap.end(), {encoded(stream(20, 16), 5), encoded(stream(20, 16), 4)});
  return {sequence_of(start),
          sequence_of(run),
          sequence_of(gap),
          sequence_of({encoded(stream(0, 8), 2)}),
          sequence_of({encoded(Play{1}, 2)}),
          sequence_of({encoded(Stop{}, 2)}),
          sequence_of({encoded(Ping{1}, 2)}),
          sequence_of({encoded(Hello{}, 0)}),
          sequence_of({encoded(Status{}, 0)}),
          sequence_of({encoded(Edge{}, 0)}),
          sequence_of({encoded(Refused{}, 0)})};
}

}  // namespace gsbench::fuzz

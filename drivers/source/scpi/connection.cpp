#include "connection.hpp"

#include "text.hpp"
#include "waveform_answer.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using transport::Clock;

namespace {

constexpr const char* kIdentify = "*IDN?";
constexpr std::size_t kSentAtOnce = 16384;
// An instrument that writes to its memory accepts nothing for a while.
constexpr double kSendingPatience_s = 2.0;
// A receiver may report room only after so many bytes were taken from its buffer.
constexpr double kBuffered_bytes = 1024.0 * 1024.0;
constexpr double kBaudsOfAByte = 10.0;
// A serial line that is silent for so long has delivered what a killed bench had asked.
constexpr double kSilence_s = 0.1;
constexpr int kMostPauses = 10;

Clock::duration time_span(double time_s) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_s));
}

}  // namespace

Connection::Connection(const Instrument& instrument, const std::string& port, int baud,
                       source::Interrupt& interrupt)
    : instrument_(instrument),
      interrupt_(interrupt),
      transport_(transport::make_transport(port, baud)),
      upload_bytes_s_(transport::is_tcp(port)
                          ? instrument.timing.upload_bytes_s
                          : std::min(instrument.timing.upload_bytes_s, baud / kBaudsOfAByte)) {}

Error Connection::interrupted(const std::string& doing) const {
  return {
      fmt::format("{}: {} ({})", transport_->port(), source::Interrupt::error().message, doing)};
}

Status Connection::pause(double time_s) {
  return interrupt_.wait_until(Clock::now() + time_span(time_s));
}

Clock::time_point Connection::answer_deadline() const {
  return std::max(Clock::now(), takes_until_) + time_span(instrument_.timing.answer_s);
}

Status Connection::open() {
  speaks_to_another_ = false;
  late_answers_ = false;
  begun_.reset();
  takes_until_ = {};
  received_.clear();
  if (Status opened = transport_->open(); !opened.ok()) {
    return opened;
  }
  if (!transport::is_tcp(transport_->port())) {
    if (Status silent = discard_answers_to_others(); !silent.ok()) {
      close();
      return silent;
    }
  }
  const Result<std::string> answer = ask(kIdentify);
  if (!answer.ok()) {
    close();
    return Error{answer.error()};
  }
  identification_ = answer.value();
  if (!instrument_.is(identification_)) {
    close();
    speaks_to_another_ = true;
    return Error{fmt::format("{}: \"{}\" is not {}, whose identity begins with \"{}\"",
                             transport_->port(), printable(identification_), instrument_.title,
                             fmt::join(instrument_.identity, "\" or \""))};
  }
  return Done{};
}

Status Connection::discard_answers_to_others() {
  for (int pauses = 0; pauses < kMostPauses; ++pauses) {
    received_.clear();
    Status got = transport_->receive(received_, Clock::now() + time_span(kSilence_s));
    if (!got.ok() || received_.empty()) {
      return got;
    }
  }
  return Done{};
}

void Connection::close() noexcept {
  transport_->close();
  begun_.reset();
}

Status Connection::write(const std::vector<std::uint8_t>& bytes) {
  const double patience_s = kSendingPatience_s + kBuffered_bytes / upload_bytes_s_;
  Status sent = transport_->send(
      bytes, std::chrono::duration_cast<std::chrono::milliseconds>(time_span(patience_s)));
  if (!sent.ok()) {
    close();
  }
  return sent;
}

Status Connection::send_at_once(const std::string& command) {
  if (interrupt_.is_set()) {
    return interrupted(fmt::format("before sending \"{}\"", command));
  }
  std::vector<std::uint8_t> bytes(command.begin(), command.end());
  bytes.push_back('\n');
  Status sent = write(bytes);
  return sent.ok() ? sent : Error{fmt::format("{} (sending \"{}\")", sent.error(), command)};
}

Status Connection::send(const std::string& command) {
  Status sent = send_at_once(command);
  return sent.ok() ? pause(instrument_.timing.command_s) : sent;
}

Status Connection::send_block(const std::string& header, const std::vector<std::uint8_t>& bytes,
                              const std::function<void(std::size_t)>& sent) {
  takes_until_ = std::max(Clock::now(), takes_until_) +
                 time_span(static_cast<double>(bytes.size()) / upload_bytes_s_);
  std::vector<std::uint8_t> part(header.begin(), header.end());
  for (std::size_t at = 0; at < bytes.size();) {
    if (interrupt_.is_set()) {
      if (at > 0) {
        close();
      }
      return interrupted(fmt::format("in the waveform, after byte {} of {}", at, bytes.size()));
    }
    const std::size_t count = std::min(kSentAtOnce, bytes.size() - at);
    part.insert(part.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                bytes.begin() + static_cast<std::ptrdiff_t>(at + count));
    at += count;
    if (at == bytes.size()) {
      part.push_back('\n');
    }
    if (Status written = write(part); !written.ok()) {
      return Error{
          fmt::format("{} (in the waveform, at byte {} of {})", written.error(), at, bytes.size())};
    }
    part.clear();
    if (sent) {
      sent(at);
    }
  }
  return Done{};
}

Error Connection::no_answer(const std::string& query) {
  late_answers_ = true;
  const std::string so_far(received_.begin(), received_.end());
  return {fmt::format("{}: no answer to \"{}\" within {} s{}{}", transport_->port(), query,
                      instrument_.timing.answer_s,
                      so_far.empty() ? "" : fmt::format(", only \"{}\"", printable(so_far)),
                      instrument_.has(Quirk::kSilentIfUnknown)
                          ? "; it does not answer what it does not know"
                          : "")};
}

Status Connection::receive(const std::string& query, Clock::time_point until) {
  const std::size_t before = received_.size();
  while (received_.size() == before) {
    if (interrupt_.is_set()) {
      late_answers_ = true;
      return interrupted(fmt::format("waiting for the answer to \"{}\"", query));
    }
    if (Clock::now() >= until) {
      return no_answer(query);
    }
    const Status got = transport_->receive(received_, source::Interrupt::part_of(until));
    if (!got.ok()) {
      close();
      return Error{fmt::format("{} (waiting for the answer to \"{}\")", got.error(), query)};
    }
  }
  return Done{};
}

std::optional<std::string> Connection::take_line() {
  const auto end = std::find(received_.begin(), received_.end(), '\n');
  if (end == received_.end()) {
    return std::nullopt;
  }
  std::string text(received_.begin(), end);
  received_.erase(received_.begin(), end + 1);
  if (!text.empty() && text.back() == '\r') {
    text.pop_back();
  }
  takes_until_ = {};  // it comes after everything that was sent
  return text;
}

Result<std::string> Connection::line(const std::string& query, Clock::time_point until) {
  for (;;) {
    if (std::optional<std::string> text = take_line()) {
      return *std::move(text);
    }
    if (Status got = receive(query, until); !got.ok()) {
      return Error{got.error()};
    }
  }
}

// Answers come in the order of the queries: what arrives before the identity is late.
Status Connection::synchronise() {
  // Twice: the first identity may be glued to half an answer.
  for (int attempt = 0; attempt < 2; ++attempt) {
    received_.clear();
    if (Status sent = send_at_once(kIdentify); !sent.ok()) {
      return sent;
    }
    const auto until = answer_deadline();
    for (Result<std::string> text = line(kIdentify, until); text.ok();
         text = line(kIdentify, until)) {
      if (instrument_.is(text.value())) {
        late_answers_ = false;
        received_.clear();
        return Done{};
      }
    }
    if (!is_open()) {
      break;
    }
    if (interrupt_.is_set()) {
      return interrupted("waiting for late answers");
    }
  }
  close();
  return Error{fmt::format("{}: does not answer any more", transport_->port())};
}

Status Connection::prepare_query(const std::string& query) {
  if (const std::optional<Begun> begun = std::exchange(begun_, std::nullopt)) {
    // Its answer must not be taken for that of the next query. After an error late_answers_ is set,
    // or the port is closed.
    static_cast<void>(line(begun->query, begun->until).ok());
  }
  if (late_answers_) {
    if (Status synchronised = synchronise(); !synchronised.ok()) {
      return synchronised;
    }
  }
  // Nothing was asked: what is here answers no query of ours.
  if (Status got = transport_->receive(received_, Clock::now()); !got.ok()) {
    close();
    return got;
  }
  received_.clear();
  return send_at_once(query);
}

Result<std::string> Connection::ask(const std::string& query) {
  if (Status sent = prepare_query(query); !sent.ok()) {
    return Error{sent.error()};
  }
  return line(query, answer_deadline());
}

Status Connection::begin_query(const std::string& query) {
  Status sent = prepare_query(query);
  if (sent.ok()) {
    begun_ = {query, answer_deadline()};
  }
  return sent;
}

Result<std::optional<std::string>> Connection::poll_answer() {
  if (const Status got = transport_->receive(received_, Clock::now()); !got.ok()) {
    const std::string query = begun_->query;
    close();
    return Error{fmt::format("{} (waiting for the answer to \"{}\")", got.error(), query)};
  }
  std::optional<std::string> text = take_line();
  if (text) {
    begun_.reset();
  } else if (Clock::now() >= begun_->until) {
    const Begun begun = *std::exchange(begun_, std::nullopt);
    return no_answer(begun.query);
  }
  return text;
}

Result<std::vector<std::uint8_t>> Connection::ask_waveform(const std::string& query) {
  if (Status sent = prepare_query(query); !sent.ok()) {
    return Error{sent.error()};
  }
  std::optional<WaveformHeader> header;
  for (;;) {
    // Each part that arrives extends the wait.
    if (Status got = receive(query, answer_deadline()); !got.ok()) {
      return Error{got.error()};
    }
    if (!header) {
      if (Status read = waveform_header(received_).move_to(header); !read.ok()) {
        late_answers_ = true;
        return Error{fmt::format("{}: {}: {}", transport_->port(), query, read.error())};
      }
    }
    if (header && received_.size() > header->data + header->bytes) {
      const auto first = received_.begin() + static_cast<std::ptrdiff_t>(header->data);
      const auto last = first + static_cast<std::ptrdiff_t>(header->bytes);
      if (*last != '\n') {
        late_answers_ = true;
        return Error{fmt::format("{}: {}: no newline after {} bytes", transport_->port(), query,
                                 header->bytes)};
      }
      std::vector<std::uint8_t> bytes(first, last);
      received_.clear();
      return bytes;
    }
  }
}

}  // namespace gsbench::scpi

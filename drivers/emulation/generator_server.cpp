#include "generator_server.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <utility>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Status;

namespace {

// How long an instrument waits for the rest of a block before it gives up.
constexpr int kBlockPatience_ms = 2000;
constexpr int kSendPatience_ms = 2000;
constexpr double kSlowStep_s = 0.01;        // of receive_bytes_s
constexpr std::size_t kLongestEntry = 200;  // of the log

}  // namespace

GeneratorServer::GeneratorServer(LoopbackPort port, GeneratorState& state,
                                 GeneratorDialect& dialect, std::mutex& mutex)
    : port_(std::move(port)),
      port_number_(port_.number()),
      state_(state),
      dialect_(dialect),
      mutex_(mutex) {}

Status GeneratorServer::start(std::chrono::milliseconds delay) {
  stop();
  if (delay.count() <= 0) {
    if (Status listening = port_.listen(); !listening.ok()) {
      return listening;
    }
  }
  wake_ = Descriptor(eventfd(0, EFD_CLOEXEC));
  thread_ = std::thread([this, from = Clock::now() + delay] { run(from); });
  return Done{};
}

void GeneratorServer::stop() {
  if (thread_.joinable()) {
    eventfd_write(wake_.get(), 1);
    thread_.join();
  }
  close_connection();
  port_.refuse();
}

void GeneratorServer::faults_changed() {
  messages_ = 0;
  bytes_ = 0;
  dumb_ = false;
  if (state_.faults().error_queue_full) {
    dialect_.fill_errors();
  }
}

void GeneratorServer::close_connection() {
  connection_.close();
  received_.clear();
}

void GeneratorServer::run(Clock::time_point from) {
  if (port_.descriptor() < 0 && (!pause_until(from) || !port_.listen().ok())) {
    return;
  }
  while (true) {
    pollfd waited[] = {{wake_.get(), POLLIN, 0},
                       {connection_.is_open() ? connection_.get() : port_.descriptor(), POLLIN, 0}};
    const bool patient = !connection_.is_open() || !dialect_.in_block();
    const int ready = ::poll(waited, 2, patient ? -1 : kBlockPatience_ms);
    if ((ready < 0 && errno != EINTR) || waited[0].revents != 0) {
      return;
    }
    if (ready == 0) {
      const std::lock_guard<std::mutex> lock(mutex_);
      dialect_.give_up_block();
      received_.clear();
    } else if (waited[1].revents != 0 && !connection_.is_open()) {
      connection_ = port_.accept();
      const std::lock_guard<std::mutex> lock(mutex_);
      dialect_.connect();
    } else if (waited[1].revents != 0) {
      serve();
    }
  }
}

void GeneratorServer::serve() {
  char chunk[65536];
  double rate_bytes_s = 0.0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    rate_bytes_s = state_.faults().receive_bytes_s;
  }
  const std::size_t most =
      rate_bytes_s > 0.0
          ? std::clamp<std::size_t>(static_cast<std::size_t>(kSlowStep_s * rate_bytes_s), 1,
                                    sizeof chunk)
          : sizeof chunk;
  const ssize_t got = ::recv(connection_.get(), chunk, most, 0);
  if (got <= 0) {
    if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
      close_connection();
    }
    return;
  }
  if (rate_bytes_s > 0.0 &&
      !pause_until(Clock::now() +
                   std::chrono::duration_cast<Clock::duration>(
                       std::chrono::duration<double>(static_cast<double>(got) / rate_bytes_s)))) {
    close_connection();
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    dialect_.arrived(state_.time().now());
    bytes_ += static_cast<std::size_t>(got);
    const std::size_t last = state_.faults().drop_at_byte;
    if (last > 0 && bytes_ >= last) {
      close_connection();
      return;
    }
  }
  received_.append(chunk, static_cast<std::size_t>(got));
  std::string_view left = received_;
  while (const std::size_t size = dialect_.message_size(left)) {
    if (!take_message(left.substr(0, size))) {
      close_connection();
      return;
    }
    left.remove_prefix(size);
  }
  received_.erase(0, received_.size() - left.size());
}

bool GeneratorServer::take_message(std::string_view message) {
  GeneratorReply reply;
  GeneratorFaults faults;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    faults = state_.faults();
    log_.emplace_back(message.substr(0, std::min(kLongestEntry, dialect_.text_size(message))));
    if (messages_left_ > 0 && --messages_left_ == 0) {
      then_();
    }
    if (++messages_ == faults.drop_at_message) {
      return false;
    }
    reply = dialect_.execute(message);
  }
  if (reply.not_before > std::numeric_limits<std::int64_t>::min()) {
    const std::int64_t wait = std::min<std::int64_t>(reply.not_before - state_.time().now(),
                                                     TrueTime::kRate_hz * 1'000'000LL);
    if (wait > 0 && !pause_until(Clock::now() + std::chrono::microseconds(wait * 1'000'000 /
                                                                          TrueTime::kRate_hz))) {
      return false;
    }
  }
  return reply.bytes.empty() || answer(std::move(reply.bytes), faults);
}

bool GeneratorServer::answer(std::string bytes, const GeneratorFaults& faults) {
  if (faults.silent || dumb_) {
    return true;
  }
  if (faults.answer_delay_s > 0) {
    const auto delay = std::chrono::duration<double>(faults.answer_delay_s);
    if (!pause_until(Clock::now() + std::chrono::duration_cast<Clock::duration>(delay))) {
      return false;
    }
  }
  if (faults.garbage_answers) {
    for (std::size_t i = 0; i + 1 < bytes.size(); ++i) {
      bytes[i] = static_cast<char>('!' + (i * 37 + 11) % 15);  // no letter and no digit
    }
  }
  if (faults.half_answers) {
    dumb_ = true;
    bytes.resize(bytes.size() / 2);
  }
  return send(bytes);
}

bool GeneratorServer::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::send(connection_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (put > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(put));
    } else if (errno != EINTR && (errno != EAGAIN || !drivers::wait_for(connection_.get(), POLLOUT,
                                                                        kSendPatience_ms))) {
      return false;
    }
  }
  return true;
}

bool GeneratorServer::pause_until(Clock::time_point time) {
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(time - Clock::now()).count();
    if (left <= 0) {
      return true;
    }
    pollfd waited[] = {{wake_.get(), POLLIN, 0}, {connection_.get(), POLLRDHUP, 0}};
    const int ready = ::poll(waited, connection_.is_open() ? 2 : 1,
                             static_cast<int>(std::min<std::int64_t>(left, 60'000)));
    if (ready > 0) {
      return false;
    }
  }
}

}  // namespace gsbench::emulation

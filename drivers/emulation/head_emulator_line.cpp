// The line between the bench and an emulated head: its thread, its frames and its faults.
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <cerrno>
#include <cmath>

#include <emulation/head_emulator.hpp>

namespace gsbench::emulation {

void HeadEmulator::serve() {
  while (true) {
    std::array<pollfd, 3> waited{};
    {
      const Lock lock(mutex_);
      if (ending_) {
        return;
      }
      if (unplugging_) {
        port_.refuse();
        connection_.close();
        unplugging_ = false;
        unplugged_.notify_all();
      }
      waited[0] = {wake_.get(), POLLIN, 0};
      waited[1] = {silent_ ? -1 : port_.descriptor(), POLLIN, 0};
      waited[2] = {silent_ ? -1 : connection_.get(), POLLIN, 0};
    }
    if (::poll(waited.data(), waited.size(), -1) < 0 && errno != EINTR) {
      return;
    }
    const Lock lock(mutex_);
    eventfd_t rung = 0;
    eventfd_read(wake_.get(), &rung);
    if (silent_) {
      continue;
    }
    if (waited[2].revents != 0 && waited[2].fd == connection_.get()) {
      read_connection();
    }
    if (waited[1].revents != 0 && waited[1].fd == port_.descriptor()) {
      if (Descriptor accepted = port_.accept(); accepted.is_open()) {
        connection_ = std::move(accepted);
      }
    }
    send_messages();
  }
}

void HeadEmulator::read_connection() {
  std::vector<std::uint8_t> bytes(4096);
  const ssize_t got = ::recv(connection_.get(), bytes.data(), bytes.size(), 0);
  if (got <= 0) {
    if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
      connection_.close();
    }
    return;
  }
  bytes.resize(static_cast<std::size_t>(got));
  if (from_bench_) {
    from_bench_(bytes);
  }
  for (const std::uint8_t byte : bytes) {
    switch (reader_.take(byte)) {
      case gs::wire::FrameReader::Taken::kNothing:
        break;
      case gs::wire::FrameReader::Taken::kBadFrame:
        head_->bad_frame();
        break;
      case gs::wire::FrameReader::Taken::kMessage:
        observation_.last_frame = observation_.code;
        ++observation_.frames;
        head_->take(reader_.message(), reader_.size());
        if (frames_until_then_ > 0 && --frames_until_then_ == 0) {
          then_();
        }
        if (frames_until_unplugged_ > 0 && --frames_until_unplugged_ == 0) {
          if (refuses_afterwards_) {
            port_.refuse();
          }
          connection_.close();
          delayed_.clear();
          return;
        }
        break;
    }
  }
}

void HeadEmulator::send_messages() {
  std::array<std::uint8_t, gs::head::kLongestUplink> message{};
  const auto now = static_cast<std::uint64_t>(std::llround(count_at(end_step_)));
  while (!silent_) {
    const std::size_t size = head_->next_message(now, message.data(), message.size());
    if (size == 0) {
      send_what_is_due();
      return;
    }
    std::vector<std::uint8_t> frame(gs::wire::kLongestFrame);
    frame.resize(gs::wire::frame(message.data(), size, frame.data(), frame.size()));
    if (to_bench_) {
      to_bench_(frame);
    }
    delayed_.push_back({std::chrono::steady_clock::now() + delay_, std::move(frame)});
  }
}

void HeadEmulator::send_what_is_due() {
  const auto now = std::chrono::steady_clock::now();
  for (; !delayed_.empty() && delayed_.front().due <= now; delayed_.pop_front()) {
    // What nobody reads is lost, as on a line without flow control.
    if (connection_.is_open()) {
      const auto& frame = delayed_.front().frame;
      static_cast<void>(
          ::send(connection_.get(), frame.data(), frame.size(), MSG_NOSIGNAL | MSG_DONTWAIT));
    }
  }
}

void HeadEmulator::ring() const {
  eventfd_write(wake_.get(), 1);
}

// ---- fault injection

// The thread closes the sockets: one that it polls would go on to listen.
void HeadEmulator::unplug() {
  std::unique_lock<std::mutex> lock(mutex_);
  unplugging_ = true;
  ring();
  unplugged_.wait(lock, [this] { return !unplugging_; });
}

void HeadEmulator::unplug_after(int frames) {
  const Lock lock(mutex_);
  frames_until_unplugged_ = frames;
  refuses_afterwards_ = true;
}

void HeadEmulator::drop_after(int frames) {
  const Lock lock(mutex_);
  frames_until_unplugged_ = frames;
  refuses_afterwards_ = false;
}

void HeadEmulator::after_frames(int frames, std::function<void()> then) {
  const Lock lock(mutex_);
  frames_until_then_ = frames;
  then_ = std::move(then);
}

void HeadEmulator::delay_to_bench(std::chrono::milliseconds delay) {
  const Lock lock(mutex_);
  delay_ = delay;
}

drivers::Status HeadEmulator::plug_in() {
  const Lock lock(mutex_);
  drivers::Status listening = port_.listen();
  ring();
  return listening;
}

void HeadEmulator::be_silent(bool silent) {
  {
    const Lock lock(mutex_);
    silent_ = silent;
  }
  ring();
}

void HeadEmulator::spoil_from_bench(Spoiler spoiler) {
  const Lock lock(mutex_);
  from_bench_ = std::move(spoiler);
}

void HeadEmulator::spoil_to_bench(Spoiler spoiler) {
  const Lock lock(mutex_);
  to_bench_ = std::move(spoiler);
}

}  // namespace gsbench::emulation

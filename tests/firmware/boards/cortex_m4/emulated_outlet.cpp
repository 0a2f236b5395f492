#include "emulated_outlet.hpp"

#include <wire_test/downlinks.hpp>
#include <wire_test/messages.hpp>

#include <algorithm>

namespace gs::test {

using gsbench::test::demand;
using gsbench::transport::Clock;

void Line::send(wire::Downlink message) {
  if (sequence_ == 0 && message.kind != wire::DownlinkKind::kIdentify) {
    send(wire::test::downlink(wire::DownlinkKind::kIdentify));
  }
  message.start_number = messages_.empty() ? 0 : messages_.back().uplink.start_number;
  demand(transport_.send(wire::test::framed(wire::test::encoded(message, sequence_++))));
}

void Line::read_for(std::chrono::milliseconds patience) {
  Message received;
  demand(transport_.receive(received, Clock::now() + patience));
  for (const Message& bytes : wire::test::frames_in(reader_, received)) {
    if (bytes.empty()) {
      throw std::runtime_error("the outlet sent a bad frame");
    }
    ReceivedMessage message;
    message.bytes = bytes;
    std::uint32_t sequence = 0;
    if (wire::decode(bytes.data(), bytes.size(), message.uplink, sequence) != wire::Decoded::kOk) {
      throw std::runtime_error("the outlet sent a message that cannot be decoded");
    }
    messages_.push_back(message);
  }
}

void Line::read_until(const std::function<bool()>& enough, const std::string& what) {
  const auto end = Clock::now() + kPatience;
  while (!enough()) {
    if (Clock::now() > end) {
      throw std::runtime_error("timeout while waiting for " + what);
    }
    read_for(std::chrono::milliseconds(100));
  }
}

std::vector<ReceivedMessage> Line::of(wire::UplinkKind kind) const {
  std::vector<ReceivedMessage> some;
  std::copy_if(messages_.begin(), messages_.end(), std::back_inserter(some),
               [&](const ReceivedMessage& message) { return message.uplink.kind == kind; });
  return some;
}

ReceivedMessage Line::wait_for(wire::UplinkKind kind, std::size_t first) {
  const auto find = [&] {
    return std::find_if(
        messages_.begin() + static_cast<std::ptrdiff_t>(std::min(first, messages_.size())),
        messages_.end(),
        [&](const ReceivedMessage& message) { return message.uplink.kind == kind; });
  };
  read_until([&] { return find() != messages_.end(); }, wire::to_string(kind));
  return *find();
}

bool Line::has_error(wire::ErrorCode code) const {
  const auto errors = of(wire::UplinkKind::kError);
  return std::any_of(errors.begin(), errors.end(), [&](const ReceivedMessage& message) {
    return message.uplink.error.code == code;
  });
}

void EmulatedOutlet::start(const std::string& program, const std::vector<std::string>& options) {
  std::vector<std::string> words;
  if (program.find(".elf") == std::string::npos) {
    words = {program, "--terminals", file_.path(), "--doorbell", file_.doorbell()};
  } else {
    words = {"qemu-system-arm",
             "-M",
             "mps2-an386,memory-backend=psram",
             "-object",
             "memory-backend-file,id=psram,size=16M,share=on,mem-path=" + file_.path(),
             "-chardev",
             "socket,id=bell,path=" + file_.doorbell(),
             "-serial",
             "chardev:bell",
             "-kernel",
             program};
  }
  words.insert(words.end(), options.begin(), options.end());
  line_.reset();
  file_.ring();  // accepts a pending connection of the previous process
  machine_ = std::make_unique<Machine>(words);
  line_ = std::make_unique<Line>(machine_->line());
}

void EmulatedOutlet::play(const std::vector<std::int16_t>& samples) {
  constexpr std::size_t kBlock = 4096;
  constexpr std::uint32_t kAhead = shared_memory_io::kRingSamples / 2;
  auto progress = Clock::now();
  std::uint32_t taken = terminals().taken;
  std::size_t done = 0;
  while (done < samples.size() || file_.behind() > 0) {
    const std::size_t count =
        std::min<std::size_t>({kBlock, kAhead - file_.behind(), samples.size() - done});
    file_.write(samples.data() + done, count);
    file_.ring();
    done += count;
    line_->read_for(std::chrono::milliseconds(count > 0 ? 0 : 2));
    if (terminals().taken != taken) {
      taken = terminals().taken;
      progress = Clock::now();
    } else if (Clock::now() > progress + kPatience) {
      throw std::runtime_error("the outlet takes no samples");
    }
  }
}

}  // namespace gs::test

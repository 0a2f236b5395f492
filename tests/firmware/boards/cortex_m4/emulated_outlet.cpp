#include "emulated_outlet.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstring>

namespace gs::test {
namespace {

constexpr std::size_t kMemoryBytes = 16U << 20U;  // the machine's PSRAM
using Clock = std::chrono::steady_clock;

}  // namespace

void Line::send(const wire::Downlink& message) {
  std::uint8_t bytes[wire::kLongestMessage];
  std::uint8_t framed[wire::kLongestFrame];
  const std::size_t size = wire::encode(message, sequence_++, bytes, sizeof bytes);
  socket_.send(framed, wire::frame(bytes, size, framed, sizeof framed));
}

void Line::read_for(std::chrono::milliseconds patience) {
  for (const char c : socket_.receive(65536, patience)) {
    switch (reader_.take(static_cast<std::uint8_t>(c))) {
      case wire::FrameReader::Taken::kNothing:
        break;
      case wire::FrameReader::Taken::kBadFrame:
        throw std::runtime_error("a bad frame from the outlet");
      case wire::FrameReader::Taken::kMessage: {
        Letter letter;
        letter.bytes.assign(reader_.message(), reader_.message() + reader_.size());
        if (wire::decode(reader_.message(), reader_.size(), letter.uplink, letter.sequence) !=
            wire::Decoded::kOk) {
          throw std::runtime_error("a message from the outlet that does not decode");
        }
        letters_.push_back(letter);
        break;
      }
    }
  }
}

void Line::read_until(const std::function<bool()>& enough, const std::string& what) {
  const auto end = Clock::now() + kPatience;
  while (!enough()) {
    if (Clock::now() > end) throw std::runtime_error("waited in vain for " + what);
    read_for(std::chrono::milliseconds(100));
  }
}

std::vector<Letter> Line::of(wire::UplinkKind kind) const {
  std::vector<Letter> some;
  std::copy_if(letters_.begin(), letters_.end(), std::back_inserter(some),
               [&](const Letter& letter) { return letter.uplink.kind == kind; });
  return some;
}

Letter Line::wait_for(wire::UplinkKind kind, std::size_t first) {
  const auto find = [&] {
    return std::find_if(
        letters_.begin() + static_cast<std::ptrdiff_t>(std::min(first, letters_.size())),
        letters_.end(), [&](const Letter& letter) { return letter.uplink.kind == kind; });
  };
  read_until([&] { return find() != letters_.end(); }, wire::to_string(kind));
  return *find();
}

bool Line::has_error(wire::ErrorCode code) const {
  const auto errors = of(wire::UplinkKind::kError);
  return std::any_of(errors.begin(), errors.end(),
                     [&](const Letter& letter) { return letter.uplink.error.code == code; });
}

struct EmulatedOutlet::Process {
  gsbench::emulation::Child child;
  Socket line;
  Socket doorbell;
};

EmulatedOutlet::EmulatedOutlet() {
  const std::string path = folder_.file("psram");
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0 || ::ftruncate(file, static_cast<off_t>(kMemoryBytes)) != 0) {
    throw std::runtime_error("no shared memory in " + path);
  }
  void* memory = ::mmap(nullptr, kMemoryBytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  if (memory == MAP_FAILED) throw std::runtime_error("mmap of " + path);
  terminals_ = static_cast<shared_memory_io::SharedMemory*>(memory);
  terminals_->magic = shared_memory_io::kMagic;
  terminals_->sample_rate_hz = 8000;
  terminals_->nominal_hz = 50;
  terminals_->counts_per_pu = 32767.0F / 1.5F;  // as firmware_test's mains
  terminals_->instance = 77;
  std::strncpy(terminals_->id, "outlet-7", sizeof terminals_->id - 1);
  // As it comes from the factory.
  std::memset(terminals_->flash, 0xFF, sizeof terminals_->flash);
}

EmulatedOutlet::~EmulatedOutlet() {
  kill();
  ::munmap(terminals_, kMemoryBytes);
}

void EmulatedOutlet::start(const std::string& image) {
  line_.reset();
  machine_ = std::make_unique<Machine>(
      folder_.path().string(),
      std::vector<std::string>{
          "-M", "mps2-an386,memory-backend=psram", "-object",
          "memory-backend-file,id=psram,size=16M,share=on,mem-path=" + folder_.file("psram"),
          "-kernel", image},
      2);
  line_ = std::make_unique<Line>(machine_->serial(0));
}

void EmulatedOutlet::start_process(const std::string& program) {
  line_.reset();
  std::string address;
  const Socket cable = Socket::listen_on_loopback(address);
  const Socket listening = Socket::listen(folder_.file("doorbell"));
  auto child = gsbench::emulation::Child::start(
      {{program, "--tcp", address, "--terminals", folder_.file("psram"), "--doorbell",
        folder_.file("doorbell")},
       ""});
  if (!child.ok()) throw std::runtime_error(child.error());
  process_ = std::make_unique<Process>(
      Process{child.take(), cable.accept(kPatience), listening.accept(kPatience)});
  line_ = std::make_unique<Line>(process_->line);
}

void EmulatedOutlet::kill() {
  if (machine_) machine_->kill();
  process_.reset();
}

void EmulatedOutlet::ring_doorbell() {
  (machine_ ? machine_->serial(1) : process_->doorbell).send("\a", 1);
}

void EmulatedOutlet::play(const std::vector<std::int16_t>& samples) {
  constexpr std::uint32_t kBlock = 4096;
  constexpr std::uint32_t kAhead = shared_memory_io::kRingSamples / 2;
  auto progress = Clock::now();
  std::uint32_t taken = terminals_->taken;
  std::size_t done = 0;
  while (done < samples.size() || terminals_->taken != terminals_->written) {
    const std::uint32_t written = terminals_->written;
    const std::uint32_t room = kAhead - (written - terminals_->taken);
    const auto count =
        static_cast<std::uint32_t>(std::min<std::size_t>({kBlock, room, samples.size() - done}));
    for (std::uint32_t i = 0; i < count; ++i) {
      terminals_->ring[(written + i) % shared_memory_io::kRingSamples] = samples[done + i];
    }
    std::atomic_thread_fence(std::memory_order_release);
    terminals_->written = written + count;
    done += count;
    if (count > 0) ring_doorbell();
    line_->read_for(std::chrono::milliseconds(count > 0 ? 0 : 2));
    if (terminals_->taken != taken) {
      taken = terminals_->taken;
      progress = Clock::now();
    } else if (Clock::now() > progress + kPatience) {
      throw std::runtime_error("the outlet takes no samples");
    }
  }
}

}  // namespace gs::test

// The mains at outlets' terminals, with outlets that are played here: what is written into their
// files, who is waited for, what the relay sense makes of a coil.
#include "adc.hpp"
#include "shared_memory_file.hpp"
#include "waiting.hpp"
#include <fcntl.h>
#include <shared_memory_io/shared_port.hpp>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstring>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <emulation/mains.hpp>

namespace {

using gs::shared_memory_io::SharedMemory;
using gs::shared_memory_io::SharedPort;
using gsbench::emulation::Descriptor;
using gsbench::emulation::Mains;
using gsbench::emulation::MainsOptions;
using gsbench::emulation::SharedMemoryFile;
using gsbench::test::TemporaryFolder;
using gsbench::test::until;
using std::chrono::steady_clock;
using testing::HasSubstr;

// What an outlet's process does with its terminals: takes samples, as long as it lives.
class TakingOutlet {
 public:
  TakingOutlet(const std::string& terminals, const std::string& doorbell)
      : file_(::open(terminals.c_str(), O_RDWR | O_CLOEXEC)),
        mapped_(mmap(nullptr, sizeof(SharedMemory), PROT_READ | PROT_WRITE, MAP_SHARED, file_.get(),
                     0)),
        port_(*static_cast<SharedMemory*>(mapped_)),
        bell_(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, doorbell.c_str(), sizeof address.sun_path - 1);
    EXPECT_EQ(connect(bell_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    port_.start();
    taking_ = std::thread([this] { take(); });
  }
  ~TakingOutlet() {
    end();
    munmap(mapped_, sizeof(SharedMemory));
  }
  TakingOutlet(const TakingOutlet&) = delete;
  TakingOutlet& operator=(const TakingOutlet&) = delete;

  void end() {
    ::shutdown(bell_.get(), SHUT_RDWR);
    if (taking_.joinable()) {
      taking_.join();
    }
  }
  void drive_relay(bool closed) { port_.drive_relay(closed); }
  std::size_t taken() const { return taken_; }
  std::uint32_t lost() const { return lost_; }

 private:
  void take() {
    char rings[64];
    while (::recv(bell_.get(), rings, sizeof rings, 0) > 0) {
      std::int16_t samples[64];
      while (port_.samples_wait()) {
        std::uint32_t lost = 0;
        taken_ += port_.take_samples(samples, 64, lost);
        lost_ += lost;
      }
    }
  }

  Descriptor file_;
  void* mapped_;
  SharedPort port_;
  Descriptor bell_;
  std::atomic<std::size_t> taken_{0};
  std::atomic<std::uint32_t> lost_{0};
  std::thread taking_;
};

class MainsAtTerminals : public testing::Test {
 protected:
  void make(std::vector<gsbench::emulation::MainsOutlet> outlets) {
    MainsOptions options;
    options.folder = folder_.path().string();
    options.outlets = std::move(outlets);
    options.real_time = false;
    auto made = Mains::create(options);
    ASSERT_TRUE(made.ok()) << made.error();
    mains_ = made.take();
  }

  std::unique_ptr<TakingOutlet> plug_in(std::size_t outlet) const {
    return std::make_unique<TakingOutlet>(mains_->terminal_path(outlet),
                                          mains_->doorbell_path(outlet));
  }

  static gsbench::source::SourceSettings settings() {
    gsbench::source::SourceSettings settings;
    settings.sample_rate_hz = 8000;
    settings.nominal_hz = 50;
    return settings;
  }

  void start() {
    const auto started = mains_->source().start(settings());
    ASSERT_TRUE(started.ok()) << started.error();
  }

  void play(std::int64_t ticks) {
    const std::vector<float> block(128);
    for (const std::int64_t end = tick_ + ticks; tick_ < end; tick_ += 128) {
      const auto played = mains_->source().play(tick_, block.data(), block.size());
      ASSERT_TRUE(played.ok()) << played.error();
    }
  }

  TemporaryFolder folder_;
  std::unique_ptr<Mains> mains_;
  std::int64_t tick_ = 0;
};

TEST_F(MainsAtTerminals, NoOutletLosesASampleHoweverFastTheSourcePlays) {
  constexpr std::int64_t kTicks = 3125 * 128;
  make({{"slow", -200.0}, {"fast", 200.0}});
  const auto slow = plug_in(0);
  const auto fast = plug_in(1);
  start();
  play(kTicks);
  // What the converters counted before the source, and what they made of its ticks but the last
  // two.
  const auto due = [](std::size_t before, double rate) {
    return before + static_cast<std::size_t>(static_cast<double>(kTicks - 2) * rate);
  };
  EXPECT_TRUE(until([&] {
    return slow->taken() >= due(800, 0.9998) && fast->taken() >= due(937, 1.0002);
  })) << slow->taken()
      << ' ' << fast->taken();
  EXPECT_EQ(slow->lost(), 0U);
  EXPECT_EQ(fast->lost(), 0U);
}

TEST_F(MainsAtTerminals, OneThatHasEndedDoesNotHoldUpTheOthersForLong) {
  make({{"dead", 0.0}, {"alive", 0.0}});
  auto dead = plug_in(0);
  const auto alive = plug_in(1);
  start();
  play(1280);
  dead->end();
  // Given up after two seconds without a sample taken, once; ten times the ring's length then.
  const auto begin = steady_clock::now();
  play(10 * 65536);
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(8));
  ASSERT_TRUE(until([&] { return alive->taken() >= 10 * 65536; }));
  EXPECT_EQ(alive->lost(), 0U);
}

TEST_F(MainsAtTerminals, TheSenseTellsAnOutletsContactAfterItsCoilByTheSourcesTicks) {
  make({{"a", 200.0}, {"b", 0.0}});
  const auto a = plug_in(0);
  const auto b = plug_in(1);
  start();
  play(80000);
  ASSERT_TRUE(until([&] { return a->taken() > 800 + 80000 && b->taken() > 937 + 79990; }));
  const std::size_t coil_sample = a->taken();
  a->drive_relay(false);
  play(2000 / 128 * 128);
  std::vector<gsbench::relay::Edge> edges;
  ASSERT_TRUE(mains_->relay_sense().poll(edges).ok());
  ASSERT_FALSE(edges.empty());
  EXPECT_EQ(edges.front().outlet, 0U);
  EXPECT_FALSE(edges.front().closed);
  // Between the coil's change and 20 ms, the slowest relay, after it; the outlet's 200 ppm, which
  // are 16 samples by now, are taken off.
  const double coil_tick = static_cast<double>(coil_sample - 800) / 1.0002;
  EXPECT_GE(static_cast<double>(edges.front().tick), coil_tick - 1.0);
  EXPECT_LE(static_cast<double>(edges.front().tick), coil_tick + 160.0);
}

TEST_F(MainsAtTerminals, TheSenseTellsNothingThatIsStillToCome) {
  make({{"a", 0.0}});
  const auto a = plug_in(0);
  start();
  play(1280);
  ASSERT_TRUE(until([&] { return a->taken() >= 800 + 1278; }));
  a->drive_relay(false);
  std::vector<gsbench::relay::Edge> edges;
  ASSERT_TRUE(mains_->relay_sense().poll(edges).ok());
  EXPECT_TRUE(edges.empty());
  play(1280);
  ASSERT_TRUE(mains_->relay_sense().poll(edges).ok());
  EXPECT_FALSE(edges.empty());
}

TEST_F(MainsAtTerminals, RefusesWhatItCannotPlay) {
  make({{"a", 0.0}});
  const float nominal[] = {0.0F, 1.0F};
  const float beyond[] = {0.0F, 1.6F};
  EXPECT_THAT(mains_->source().play(0, nominal, 2).error(), HasSubstr("before it was started"));
  gsbench::source::SourceSettings other = settings();
  other.sample_rate_hz = 4000;
  EXPECT_THAT(mains_->source().start(other).error(), HasSubstr("sample at 8000 Hz"));
  other = settings();
  other.nominal_hz = 60;
  EXPECT_THAT(mains_->source().start(other).error(), HasSubstr("mains of 50 Hz"));
  start();
  EXPECT_THAT(mains_->source().play(7, nominal, 2).error(), HasSubstr("asked for tick 7"));
  EXPECT_THAT(mains_->source().play(0, beyond, 2).error(), HasSubstr("beyond its full scale"));
  mains_->source().make_safe();
  EXPECT_FALSE(mains_->source().play(0, nominal, 2).ok());
}

TEST(SharedMemoryFile, CountsWhatAnOutletHasStillToTake) {
  const TemporaryFolder folder;
  gsbench::emulation::SharedMemorySettings settings;
  settings.id = "a";
  auto made = SharedMemoryFile::create(folder.path().string(), settings);
  ASSERT_TRUE(made.ok()) << made.error();
  SharedMemoryFile file = made.take();
  const std::vector<std::int16_t> samples(100);
  file.write(samples.data(), samples.size());
  EXPECT_EQ(file.behind(), 100U);
  SharedPort port(file.terminals());
  std::int16_t taken[30];
  std::uint32_t lost = 0;
  EXPECT_EQ(port.take_samples(taken, 30, lost), 30U);
  EXPECT_EQ(file.behind(), 70U);
}

TEST(SharedMemoryFile, IsMadeOnceForAnIdAndGoesWithItsOwner) {
  const TemporaryFolder folder;
  gsbench::emulation::SharedMemorySettings settings;
  settings.id = "a";
  {
    const auto first = SharedMemoryFile::create(folder.path().string(), settings);
    ASSERT_TRUE(first.ok());
    const auto second = SharedMemoryFile::create(folder.path().string(), settings);
    ASSERT_FALSE(second.ok());
    EXPECT_THAT(second.error(), HasSubstr("a.terminals: File exists"));
  }
  EXPECT_THAT(folder.entries(), testing::IsEmpty());
}

}  // namespace

// The emulated mains with fake outlets: samples in the shared memory, waiting for slow outlets, and
// the relay sense's edges after a change of the coil.
#include "fake_outlet.hpp"
#include "shared_memory_file.hpp"
#include <test_support/demand.hpp>
#include <test_support/mains.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <algorithm>
#include <chrono>

#include <gmock/gmock.h>

#include <emulation/mains.hpp>

namespace {

using gs::shared_memory_io::SharedPort;
using gsbench::emulation::Mains;
using gsbench::emulation::MainsOptions;
using gsbench::emulation::SharedMemoryFile;
using gsbench::test::demand;
using gsbench::test::FakeOutlet;
using gsbench::test::TemporaryFolder;
using gsbench::test::until;
using std::chrono::steady_clock;
using testing::HasSubstr;

class MainsAtTerminals : public testing::Test {
 protected:
  void make(std::vector<gsbench::emulation::MainsOutlet> outlets) {
    MainsOptions options;
    options.folder = folder_.path().string();
    options.outlets = std::move(outlets);
    options.real_time = false;
    mains_ = demand(Mains::create(options));
  }

  std::unique_ptr<FakeOutlet> plug_in(std::size_t outlet) const {
    return std::make_unique<FakeOutlet>(*mains_, outlet);
  }

  void start() { gsbench::test::start(mains_->source(), stimulus_); }

  void play(std::int64_t ticks) {
    for (const std::int64_t end = tick_ + ticks; tick_ < end;) {
      tick_ += 128;
      gsbench::test::advance(mains_->source(), tick_);
    }
  }

  TemporaryFolder folder_;
  gsbench::test::Mains stimulus_;
  std::unique_ptr<Mains> mains_;
  std::int64_t tick_ = 0;
};

TEST_F(MainsAtTerminals, NoOutletLosesSamplesWithoutRealTime) {
  constexpr std::int64_t kTicks = 3125 * 128;
  make({{"slow", -200.0}, {"fast", 200.0}});
  const auto slow = plug_in(0);
  const auto fast = plug_in(1);
  start();
  play(kTicks);
  // The samples before the stimulus, plus those made of its ticks except the last two.
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

TEST_F(MainsAtTerminals, StopsWaitingForAnOutletThatHasEnded) {
  make({{"dead", 0.0}, {"alive", 0.0}});
  stimulus_.duration_s = 90.0;
  auto dead = plug_in(0);
  const auto alive = plug_in(1);
  start();
  play(1280);
  dead->end();
  // The source stops waiting after 2 s, once; then it plays ten times the ring's length.
  const auto begin = steady_clock::now();
  play(10 * 65536);
  EXPECT_LT(steady_clock::now() - begin, std::chrono::seconds(8));
  ASSERT_TRUE(until([&] { return alive->taken() >= 10 * 65536; }));
  EXPECT_EQ(alive->lost(), 0U);
}

TEST_F(MainsAtTerminals, RelaySenseCorrectsForTheOutletsCrystal) {
  make({{"a", 200.0}});
  const auto a = plug_in(0);
  start();
  play(80000);
  ASSERT_TRUE(until([&] { return a->taken() == mains_->terminals(0).written; }));
  // 200 ppm of 80000 ticks are 16 samples.
  EXPECT_EQ(a->taken(), 800U + 80000U - 2U + 16U);
  a->drive_relay(false);
  play(2000 / 128 * 128);
  std::vector<gsbench::relay::Edge> edges;
  ASSERT_TRUE(mains_->relay_sense().poll(edges).ok());
  ASSERT_EQ(edges.size(), 1U);
  // The relay takes 6.5 to 9.5 ms.
  EXPECT_NEAR(static_cast<double>(edges[0].count), 79998.0 + 64.0, 12.0 + 1.0);
}

TEST_F(MainsAtTerminals, OutletsGetNominalVoltageInPhaseBeforeTheStimulus) {
  make({{"a", 0.0}});
  std::vector<std::int16_t> taken;
  FakeOutlet a(*mains_, 0, [&](const std::int16_t* samples, std::size_t count) {
    taken.insert(taken.end(), samples, samples + count);
  });
  start();
  play(1280);
  ASSERT_TRUE(until([&] { return a.taken() == mains_->terminals(0).written; }));
  a.end();
  ASSERT_EQ(taken.size(), 800U + 1278U);
  for (std::size_t i = 0; i + 160 < taken.size(); ++i) {
    ASSERT_NEAR(taken[i], taken[i + 160], 2) << "at sample " << i;
  }
  EXPECT_NEAR(*std::max_element(taken.begin(), taken.begin() + 800), 32767 / 1.5, 2);
}

TEST(SharedMemoryFile, CountsTheSamplesNotReadYet) {
  const TemporaryFolder folder;
  SharedMemoryFile file = demand(SharedMemoryFile::create(folder.path().string(), {"a"}));
  const std::vector<std::int16_t> samples(100);
  file.write(samples.data(), samples.size());
  EXPECT_EQ(file.behind(), 100U);
  SharedPort port(file.terminals());
  std::int16_t taken[30];
  std::uint32_t lost = 0;
  EXPECT_EQ(port.take_samples(taken, 30, lost), 30U);
  EXPECT_EQ(file.behind(), 70U);
}

TEST(SharedMemoryFile, IsCreatedOncePerIdAndRemovedByItsOwner) {
  const TemporaryFolder folder;
  {
    const auto first = SharedMemoryFile::create(folder.path().string(), {"a"});
    ASSERT_TRUE(first.ok());
    EXPECT_THAT(SharedMemoryFile::create(folder.path().string(), {"a"}).error(),
                HasSubstr("a.terminals: File exists"));
  }
  EXPECT_THAT(folder.entries(), testing::IsEmpty());
}

}  // namespace

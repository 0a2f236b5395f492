#include "fake_outlet.hpp"
#include "rigs.hpp"
#include <test_support/mains.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

namespace gsbench::test {
namespace {

// Two outlets with crystal errors of ±200 ppm.
class EmulatedRig final : public RelayRig {
 public:
  EmulatedRig() {
    emulation::MainsOptions options;
    options.folder = folder_.path().string();
    options.outlets = {{"a", 200.0}, {"b", -200.0}};
    options.real_time = false;
    mains_ = emulation::Mains::create(options).take();
    for (std::size_t i = 0; i < 2; ++i) {
      outlets_.push_back(std::make_unique<FakeOutlet>(*mains_, i));
    }
    start(mains_->source(), stimulus_);
  }
  relay::RelaySense& sense() override { return mains_->relay_sense(); }
  void turn(std::size_t channel, bool closed) override { outlets_[channel]->drive_relay(closed); }
  void advance(std::int64_t until_tick) override {
    test::advance(mains_->source(), until_tick);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_TRUE(until([&] { return outlets_[i]->taken() == mains_->terminals(i).written; }));
    }
  }

 private:
  TemporaryFolder folder_;
  Mains stimulus_;
  std::unique_ptr<emulation::Mains> mains_;
  std::vector<std::unique_ptr<FakeOutlet>> outlets_;
};

}  // namespace

std::unique_ptr<RelayRig> emulated_sense() {
  return std::make_unique<EmulatedRig>();
}

}  // namespace gsbench::test

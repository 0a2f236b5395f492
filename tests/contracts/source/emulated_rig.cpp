#include "fake_outlet.hpp"
#include "measuring_outlet.hpp"
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <mutex>

namespace gsbench::test {
namespace {

// Samples of the first outlet's ADC before the stimulus.
constexpr std::int64_t kBefore = 800;

class EmulatedRig final : public SourceRig {
 public:
  EmulatedRig() {
    emulation::MainsOptions options;
    options.folder = folder_.path().string();
    options.outlets = {{"outlet", 0.0}};
    options.real_time = false;
    mains_ = emulation::Mains::create(options).take();
    fake_outlet_ = std::make_unique<FakeOutlet>(
        *mains_, 0, [this](const std::int16_t* samples, std::size_t count) {
          const std::lock_guard<std::mutex> lock(mutex_);
          outlet_.feed(samples, count);
        });
  }
  source::Source& source() override { return mains_->source(); }

  std::vector<Reading> readings() override {
    EXPECT_TRUE(until([&] { return fake_outlet_->taken() == mains_->terminals(0).written; }));
    const std::lock_guard<std::mutex> lock(mutex_);
    return outlet_.measurements().after(kBefore);
  }

 private:
  TemporaryFolder folder_;
  std::unique_ptr<emulation::Mains> mains_;
  std::mutex mutex_;
  MeasuringOutlet outlet_;
  std::unique_ptr<FakeOutlet> fake_outlet_;  // last: its thread ends before the members it uses
};

}  // namespace

std::unique_ptr<SourceRig> emulated_mains() {
  return std::make_unique<EmulatedRig>();
}

}  // namespace gsbench::test

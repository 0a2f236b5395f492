// The wire in real time: what an instrument puts out arrives at the outlets with the right
// amplitude and frequency, and edges of contacts come back with their true step.
#include "fake_outlet.hpp"
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <cmath>
#include <complex>
#include <mutex>

#include <gmock/gmock.h>

#include <emulation/wire.hpp>

namespace gsbench::test {
namespace {

using emulation::Terminals;
using emulation::TrueTime;
using emulation::Wire;
using emulation::WireOptions;

constexpr double kTau = 6.283185307179586;
constexpr double kCounts_pu = 32767.0 / 1.5;

struct Tone {
  double frequency_hz;
  double peak_v;
};

// Sines, and a check of the order of calls.
class Tones final : public emulation::Output {
 public:
  explicit Tones(std::vector<Tone> tones) : tones_(std::move(tones)) {}
  void render(std::int64_t first_step, std::size_t count, float* volts) override {
    gaps_ += first_step == next_ ? 0 : 1;
    next_ = first_step + static_cast<std::int64_t>(count);
    for (std::size_t i = 0; i < count; ++i) {
      const double t_s =
          (static_cast<double>(first_step) + static_cast<double>(i) + 0.5) / TrueTime::kRate_hz;
      double sum_v = 0.0;
      for (const Tone& tone : tones_) {
        sum_v += tone.peak_v * std::sin(kTau * tone.frequency_hz * t_s);
      }
      volts[i] = static_cast<float>(sum_v);
    }
  }
  int gaps() const { return gaps_; }

 private:
  std::vector<Tone> tones_;
  std::atomic<std::int64_t> next_{0};
  std::atomic<int> gaps_{0};
};

struct Passed {
  std::size_t outlet;
  std::int64_t step;
  bool closed;
};

class OnTheWire : public testing::Test {
 protected:
  // Outlets with crystals of ±500 ppm.
  void connect(std::vector<Tone> tones, WireOptions options = {}) {
    terminals_ =
        demand(Terminals::create({folder_.path().string(), {{"fast", 500.0}, {"slow", -500.0}}}));
    for (std::size_t i = 0; i < 2; ++i) {
      outlets_.push_back(std::make_unique<FakeOutlet>(
          *terminals_, i, [this, i](const std::int16_t* samples, std::size_t count) {
            const std::lock_guard<std::mutex> lock(mutex_);
            samples_[i].insert(samples_[i].end(), samples, samples + count);
          }));
    }
    output_ = std::make_unique<Tones>(std::move(tones));
    options.on_edge = [this](std::size_t outlet, std::int64_t step, bool closed) {
      const std::lock_guard<std::mutex> lock(mutex_);
      passed_.push_back({outlet, step, closed});
    };
    wire_ = std::make_unique<Wire>(*terminals_, *output_, TrueTime(), options);
  }

  std::vector<std::int16_t> samples(std::size_t outlet, std::size_t count) {
    EXPECT_TRUE(until([&] { return outlets_[outlet]->taken() >= count; }));
    const std::lock_guard<std::mutex> lock(mutex_);
    return samples_[outlet];
  }
  std::vector<Passed> passed() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return passed_;
  }

  // Peak, per unit, and phase at this frequency of 0.4 s of samples.
  static std::complex<double> phasor(const std::vector<std::int16_t>& samples, std::size_t from,
                                     double frequency_hz) {
    constexpr std::size_t kCount = 3200;
    std::complex<double> sum;
    for (std::size_t n = from; n < from + kCount; ++n) {
      sum += static_cast<double>(samples[n]) / kCounts_pu *
             std::polar(1.0, -kTau * frequency_hz * static_cast<double>(n) / 8000.0);
    }
    return sum * (2.0 / static_cast<double>(kCount));
  }

  TemporaryFolder folder_;
  std::mutex mutex_;
  std::vector<std::int16_t> samples_[2];
  std::vector<Passed> passed_;
  std::unique_ptr<Terminals> terminals_;
  std::vector<std::unique_ptr<FakeOutlet>> outlets_;
  std::unique_ptr<Tones> output_;
  std::unique_ptr<Wire> wire_;
};

TEST_F(OnTheWire, ASineArrivesWithItsAmplitudeAndFrequencyOnEachCrystal) {
  WireOptions options;
  options.gain = 50.0;
  options.nominal_v = 120.0;
  // 0.8 of the nominal peak of 169.7 V.
  connect({{50.0, 0.8 * 120.0 * std::sqrt(2.0) / 50.0}}, options);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<std::int16_t> all = samples(i, 8000);
    const std::complex<double> early = phasor(all, 400, 50.0);
    const std::complex<double> late = phasor(all, 4400, 50.0);
    EXPECT_NEAR(std::abs(early), 0.8, 0.001);
    EXPECT_NEAR(std::abs(late), 0.8, 0.001);
    // The phase turns in 0.5 s of samples; a fast clock measures a low frequency.
    const double measured_ppm = std::arg(late / early) / kTau / 0.5 / 50.0 * 1e6;
    EXPECT_NEAR(measured_ppm, i == 0 ? -500.0 : 500.0, 10.0);
  }
  EXPECT_EQ(output_->gaps(), 0);
  EXPECT_EQ(outlets_[0]->lost() + outlets_[1]->lost(), 0U);
  EXPECT_THAT(passed(), testing::IsEmpty());
}

TEST_F(OnTheWire, HarmonicsPassAndImagesOfDacStepsAreAttenuated) {
  WireOptions options;
  options.nominal_v = 1.0 / std::sqrt(2.0);  // 1 V of peak is 1 pu
  connect({{250.0, 0.5}, {6000.0, 0.5}, {15000.0, 0.4}}, options);
  const std::vector<std::int16_t> all = samples(0, 4000);
  // A clock that is 500 ppm fast.
  const auto peak_at = [&](double frequency_hz) {
    return std::abs(phasor(all, 400, frequency_hz / 1.0005));
  };
  // (250/2000)⁴ is 2.4e-4, its half 1.2e-4 of attenuation.
  EXPECT_NEAR(peak_at(250.0), 0.5, 0.002);
  // tan(π·6/64) / tan(π·2/64) is 3.08, so 6 kHz is reduced to 1/√(1 + 3.08⁴) = 0.105.
  EXPECT_NEAR(peak_at(6000.0), 0.5 * 0.105, 0.003);
  // 15 kHz is reduced to 0.0118.
  EXPECT_NEAR(peak_at(15000.0), 0.4 * 0.0118, 0.001);
}

TEST_F(OnTheWire, EdgesOfContactsComeBackWithTheirStep) {
  connect({{50.0, 325.0}});
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_TRUE(wire_->contact_closed(i));
    ASSERT_TRUE(until([&] { return outlets_[i]->taken() > 1000; }));
    outlets_[i]->drive_relay(false);
  }
  ASSERT_TRUE(until([&] { return passed().size() >= 2; }));
  for (const Passed& edge : passed()) {
    EXPECT_FALSE(edge.closed);
    EXPECT_FALSE(wire_->contact_closed(edge.outlet)) << "what was passed has happened";
    const double coil_s = terminals_->memory(edge.outlet).edge[0].sample / 8000.0 /
                          (edge.outlet == 0 ? 1.0005 : 0.9995);
    const double edge_s = static_cast<double>(edge.step) / TrueTime::kRate_hz;
    EXPECT_GT(edge_s, coil_s + 0.0064);
    EXPECT_LT(edge_s, coil_s + 0.0096);
  }
  ASSERT_TRUE(until([&] { return wire_->step() > 64000 / 8; }));
  EXPECT_EQ(passed().size(), 2U) << "an opening contact does not bounce";
  EXPECT_GE(wire_->worst_lateness_s(), 0.0);
  EXPECT_LT(wire_->worst_lateness_s(), 1.0);
}

TEST_F(OnTheWire, AnEdgeThatBecomesKnownLateKeepsItsStepAndIsCountedAsLate) {
  connect({{50.0, 325.0}});
  ASSERT_TRUE(until([&] { return wire_->step() > 64000 / 4; }));
  // As by an outlet's process that was not scheduled for a while: the coil at sample 80, 10 ms.
  gs::shared_memory_io::SharedMemory& memory = terminals_->memory(1);
  memory.edge[0] = {80, 0};
  memory.edges = 1;
  ASSERT_TRUE(until([&] { return !passed().empty(); }));
  EXPECT_NEAR(static_cast<double>(passed()[0].step), 64.0 * (10.0 + 8.0), 64.0 * 1.6);
  EXPECT_GT(wire_->worst_lateness_s(), 0.25 - 0.02 - 0.008);
}

TEST_F(OnTheWire, EndsWhileOutletsAreGone) {
  connect({{50.0, 325.0}});
  ASSERT_TRUE(until([&] { return wire_->step() > 640; }));
  outlets_.clear();
  const std::int64_t step = wire_->step();
  ASSERT_TRUE(until([&] { return wire_->step() > step + 640; }));
  wire_.reset();
  EXPECT_EQ(output_->gaps(), 0);
}

}  // namespace
}  // namespace gsbench::test

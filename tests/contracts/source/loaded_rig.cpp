// A model of an arbitrary waveform generator: resamples the whole stimulus into a memory with its
// own rate and resolution, and plays it on its own.
#include "measuring_outlet.hpp"

#include <cmath>

namespace gsbench::test {
namespace {

constexpr double kFullScale_pu = 1.25;
constexpr double kMemoryRate_hz = 10000.0;
constexpr double kStep_pu = kFullScale_pu / 8192.0;
constexpr double kLongest_s = 30.0;
constexpr std::int64_t kUploadedAtOnce = 4000;
constexpr std::int64_t kPolledTicks = 80;  // its position is polled every 10 ms

double rounded(double voltage_pu) {
  return kStep_pu * std::round(voltage_pu / kStep_pu);
}

class LoadedSource final : public source::Source {
 public:
  explicit LoadedSource(MeasuringOutlet& outlet) : outlet_(outlet) {}

  source::Limits limits() const override {
    return {"waveform generator",
            source::Kind::kLoaded,
            kFullScale_pu,
            kLongest_s,
            {8000},
            {50},
            false};
  }

 protected:
  drivers::Result<source::Played> deviation(const source::Stimulus& stimulus) const override {
    std::vector<float> ideal(static_cast<std::size_t>(stimulus.total_ticks()));
    stimulus.render(0, ideal.size(), ideal.data());
    const std::vector<double> memory = resampled(ideal.data(), ideal.size());
    source::Played played;
    for (std::size_t n = 0; n < ideal.size(); ++n) {
      played.voltage_pu = std::fmax(played.voltage_pu,
                                    std::fabs(output(memory, n) - static_cast<double>(ideal[n])));
    }
    return played;
  }

  drivers::Status upload(const source::Progress& progress) override {
    const std::int64_t total = stimulus().total_ticks();
    std::vector<float> all;
    for (std::int64_t tick = 0; tick < total; tick += kUploadedAtOnce) {
      const std::int64_t count = std::min(kUploadedAtOnce, total - tick);
      const auto voltage_pu = samples(tick, count);
      if (!voltage_pu.ok()) {
        return drivers::Error{voltage_pu.error()};
      }
      all.insert(all.end(), voltage_pu.value(), voltage_pu.value() + count);
      if (progress) {
        progress(static_cast<double>(tick + count) / static_cast<double>(total));
      }
    }
    memory_ = resampled(all.data(), all.size());
    return drivers::Done{};
  }

  drivers::Status power_up() override { return drivers::Done{}; }
  drivers::Status begin() override { return drivers::Done{}; }

  drivers::Result<std::int64_t> play_until(std::int64_t until_tick) override {
    const std::int64_t polled = (until_tick + kPolledTicks - 1) / kPolledTicks * kPolledTicks;
    const std::int64_t end = std::min(polled, stimulus().total_ticks());
    for (std::int64_t n = tick(); n < end; ++n) {
      outlet_.feed(output(memory_, static_cast<std::size_t>(n)));
    }
    return end;
  }

  drivers::Status switch_off() noexcept override { return drivers::Done{}; }

 private:
  // At the memory's rate, linear between the stimulus's samples.
  static std::vector<double> resampled(const float* ideal, std::size_t count) {
    std::vector<double> memory;
    for (double at = 0.0; at < static_cast<double>(count - 1); at = memory_ticks(memory.size())) {
      const auto n = static_cast<std::size_t>(at);
      const double part = at - static_cast<double>(n);
      memory.push_back(rounded((1.0 - part) * static_cast<double>(ideal[n]) +
                               part * static_cast<double>(ideal[n + 1])));
    }
    return memory;
  }
  static double memory_ticks(std::size_t entry) {
    return static_cast<double>(entry) * 8000.0 / kMemoryRate_hz;
  }
  // At a tick of the stimulus, after the reconstruction filter.
  static double output(const std::vector<double>& memory, std::size_t tick) {
    const double at = static_cast<double>(tick) * kMemoryRate_hz / 8000.0;
    const auto entry = static_cast<std::size_t>(at);
    if (entry + 1 >= memory.size()) {
      return memory.back();
    }
    const double part = at - static_cast<double>(entry);
    return (1.0 - part) * memory[entry] + part * memory[entry + 1];
  }

  MeasuringOutlet& outlet_;
  std::vector<double> memory_;
};

class LoadedRig final : public SourceRig {
 public:
  source::Source& source() override { return source_; }
  std::vector<Reading> readings() override { return outlet_.measurements().after(0); }

 private:
  MeasuringOutlet outlet_;
  LoadedSource source_{outlet_};
};

}  // namespace

std::unique_ptr<SourceRig> loaded_source() {
  return std::make_unique<LoadedRig>();
}

}  // namespace gsbench::test

// The firmware with a voltage at its terminals, and its measurements.
#pragma once

#include "rigs.hpp"

#include <vector>

#include <app/application.hpp>
#include <models/adc.hpp>

namespace gsbench::test {

class Measurements final : public gs::app::Outbox {
 public:
  void take_hello(const gs::wire::Hello& hello) {
    delay_ticks_ =
        static_cast<double>(hello.tracker_delay_s) * static_cast<double>(hello.sample_rate_hz);
  }
  void put(const gs::wire::Uplink& message) override {
    if (message.kind == gs::wire::UplinkKind::kHello) {
      take_hello(message.hello);
    } else if (message.kind == gs::wire::UplinkKind::kMeasurement &&
               message.measurement.validity == gs::outlet::Validity::kValid) {
      const double tick = static_cast<double>(message.sample) - delay_ticks_;
      readings_.push_back({static_cast<std::int64_t>(tick),
                           static_cast<double>(message.measurement.frequency_hz),
                           static_cast<double>(message.measurement.voltage_pu)});
    }
  }
  // On the stimulus's ticks, if it started after `samples` samples.
  std::vector<Reading> after(std::int64_t samples) const {
    std::vector<Reading> readings = readings_;
    for (Reading& reading : readings) {
      reading.tick -= samples;
    }
    return readings;
  }

 private:
  double delay_ticks_ = 0.0;
  std::vector<Reading> readings_;
};

class MeasuringOutlet {
 public:
  MeasuringOutlet() { app_.start({8000, 50, models::kCounts_per_pu}, {}, nullptr, measurements_); }

  void feed(const std::int16_t* counts, std::size_t count) {
    app_.feed(counts, count, measurements_);
  }
  void feed(double voltage_pu) {
    const std::int16_t counts =
        models::adc_counts(static_cast<float>(voltage_pu), models::kCounts_per_pu);
    feed(&counts, 1);
  }
  const Measurements& measurements() const { return measurements_; }

 private:
  gs::app::Application app_;
  Measurements measurements_;
};

}  // namespace gsbench::test

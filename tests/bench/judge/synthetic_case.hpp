// Records in which the value of every measure is known, for judging and for mutants.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <judge/judge.hpp>
#include <measures/catalogue.hpp>

namespace gsbench::judge::test {

// 50 Hz until `from_s`, then falling by 0.4 Hz/s for a second, then constant.
class FallingReference final : public waveform::ReferenceSignal {
 public:
  explicit FallingReference(double from_s) : from_s_(from_s) {}
  double nominal_hz() const override { return 50.0; }
  double frequency_hz(double t_s) const override;
  double rocof_hz_s(double t_s) const override;
  double excess_cycles(double) const override { return 0.0; }  // not used by any measure
  double voltage_pu(double) const override { return 1.0; }
  std::vector<double> corners_s() const override { return {from_s_, from_s_ + 1.0}; }

 private:
  double from_s_;
};

struct SyntheticCase {
  profile::Plan plan;
  std::shared_ptr<const waveform::ReferenceSignal> reference;
  record::OutletRecord outlet;
  record::BenchUncertainty uncertainty;

  Case view() const;  // with all traces
  Reading read(const std::string& measure) const { return reading_of(measure)(view()); }

  void add_mark(std::int64_t tick, const std::string& kind, double value,
                const std::string& text = "");
  void remove_marks(const std::string& kind);
  void move_marks(const std::string& kind, std::int64_t by_ticks);
  void set_marks(const std::string& kind, double value);
  // Keeps only the first `reports` reports.
  void cut_trace(std::size_t reports);
};

using Change = std::function<void(SyntheticCase&)>;

// A record of six seconds at 1000 samples/s (1 tick = 1 ms) with a loss of 500 MW at 3 s.
//
// The outlet reports every 16 ms. Reports are valid from 0.112 s on, except for four around 1.1 s.
// They follow the reference with a delay of 28 ms. The frequency is 1 mHz too high, with
// alternating errors of ±2 mHz; the ROCOF has alternating errors of ±0.1 Hz/s.
//
//   3.120 s  event
//   3.280 s  LSE: 450 MW
//   3.920 s  decision: 515 MW lost at 3.010 s, 30 hits; the relay is ordered to open
//   3.928 s  the contact opens
//
// The outlet's clock is 30 ± 8 ppm fast; its time stamps have an uncertainty of 0.4 ms.
SyntheticCase loss_of_500_mw();

// A record without a loss: command to switch off at 2.000 s, order to the relay at 2.005 s, contact
// open at 2.012 s.
SyntheticCase commanded();

// Limits in the measure's own unit unless `unit` is given.
profile::Expectation limits(const std::string& measure, std::optional<double> min,
                            std::optional<double> max, const char* unit = nullptr);

// The verdict of `judge_outlet` on one expectation.
record::Verdict verdict(SyntheticCase c, const profile::Expectation& expectation);

}  // namespace gsbench::judge::test

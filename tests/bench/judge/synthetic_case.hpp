// A record in which every measurement is known by hand, to judge and to spoil.
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
  double excess_cycles(double) const override { return 0.0; }  // no measurement asks for it
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

  Case view() const { return {plan, *reference, outlet, uncertainty}; }
  Reading read(const std::string& measure) const { return reading_of(measure)(view()); }

  void add_mark(std::int64_t tick, const std::string& kind, double value,
                const std::string& text = "");
  void remove_marks(const std::string& kind);
  void move_marks(const std::string& kind, std::int64_t by_ticks);
  void set_marks(const std::string& kind, double value);
  // Keeps that many reports, from the first on.
  void cut_trace(std::size_t reports);
};

using Change = std::function<void(SyntheticCase&)>;

// Six seconds at 1000 samples a second, so that a tick is a millisecond; 500 MW lost at 3 s.
//
// The outlet's reports come every 16 ms, valid from 0.112 s on but for four around 1.1 s, and are
// of the reference 28 ms earlier: the frequency 1 mHz too high with 2 mHz more and less in turn,
// the ROCOF 0.1 Hz/s too high and too low in turn. It detects the event at 3.120 s, has an LSE of
// 450 MW at 3.280 s, and decides at 3.920 s on 515 MW, lost at 3.010 s, with 30 hits. Its relay is
// told to open then, and does at 3.928 s. Its clock is 30 ± 8 ppm fast, its stamps good to 0.4 ms.
SyntheticCase loss_of_500_mw();

// Without a loss: switched off by command at 2.000 s; ordered to the relay at 2.005 s, open at
// 2.012 s.
SyntheticCase commanded();

// In the measure's own unit, unless another is named.
profile::Expectation limits(const std::string& measure, std::optional<double> min,
                            std::optional<double> max, const char* unit = nullptr);

// The verdict of `judge_outlet` on one expectation.
record::Verdict verdict(SyntheticCase c, const profile::Expectation& expectation);

}  // namespace gsbench::judge::test

// A relay sense that exists in emulation only. It sees the contacts at the outlets' terminals, in
// true time, and the voltage there. The first dip of the stimulus aligns it with the source, so
// that it does not depend on when the bench believes that the source has started. If the stimulus
// has no dip, Source::host_clock() aligns it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <emulation/output.hpp>
#include <relay/relay_sense.hpp>
#include <source/source.hpp>

namespace gsbench::emulation {

// Finds the first dip in a voltage: the mean square over one nominal period falls below `ratio` of
// the mean square over the three periods before it.
class DipFinder {
 public:
  DipFinder(std::int64_t samples_per_period, double ratio);
  // The next sample. Returns the end of the period in which the mean square has fallen, in samples,
  // interpolated, once it is found; the first sample is the interval 0 … 1.
  std::optional<double> take(double voltage);

 private:
  std::int64_t period_;
  double ratio_;
  std::vector<double> squares_;  // of the newest four periods, as a ring
  std::int64_t taken_ = 0;
  double recent_ = 0.0;  // sum over the newest period
  double before_ = 0.0;  // and over the three before it
  double last_excess_ = 0.0;
};

// seen() and moved() are called from the wire's thread (emulation/wire.hpp), the others from the
// run's.
class TerminalSense final : public relay::RelaySense {
 public:
  // `stimulus`: that of the source. A dip counts after at least four nominal periods.
  // `clock_ppm`: true error of the source's clock, positive: fast. `source` must outlive this.
  TerminalSense(const source::Stimulus& stimulus, const source::Source& source, double clock_ppm,
                const TrueTime& time);

  void seen(const float* voltage_pu, std::size_t count);
  void moved(std::size_t channel, std::int64_t step, bool closed);

  // Counts are steps of true time.
  relay::Alignment alignment() const override;
  std::string not_known_yet() const override;
  bool is_aligned_by_dips() const { return aligned_by_dips_; }
  std::optional<std::int64_t> count_at(std::chrono::steady_clock::time_point time) const override;
  // Edges are held back until the dip has been seen. An error if it has not been seen 1 s after the
  // source says that it was played.
  drivers::Status poll(std::vector<relay::Edge>& edges) override;

 private:
  const source::Source& source_;
  TrueTime time_;
  double rate_hz_;
  double steps_per_tick_;
  bool aligned_by_dips_ = false;
  double dip_ticks_ = 0.0;
  mutable std::mutex mutex_;
  // Under mutex_:
  std::optional<DipFinder> finder_;  // none: the stimulus has no dip
  std::optional<double> dip_steps_;
  std::vector<relay::Edge> edges_;
};

}  // namespace gsbench::emulation

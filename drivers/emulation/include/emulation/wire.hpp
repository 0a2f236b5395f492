// The wire from an emulated instrument to the emulated outlets, in true time. The chain:
//
//   instrument's output (V, mean over each step of 64 kHz) → gain of the emulated amplifier and
//   transformer → low-pass → per unit of the nominal peak → the ADC of each outlet
//
// The low-pass is a Butterworth filter of second order. It stands for the reconstruction filter
// after the source's DAC, and the divider and anti-aliasing filter before the outlet's ADC. With
// 2 kHz it attenuates 50 Hz by less than 1e-6 and delays the voltage by 0.11 ms. It adds no noise:
// noise comes from the source.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include <emulation/output.hpp>
#include <emulation/terminals.hpp>

namespace gsbench::emulation {

struct WireOptions {
  double gain = 1.0;         // V at the outlets per V at the instrument's terminals
  double nominal_v = 230.0;  // RMS at the outlets
  double cutoff_hz = 2000.0;
  std::uint64_t seed = 0;  // of the contacts' operating times and bounces
  // Both are called from the wire's thread and must not block.
  // A contact has moved at `step` of true time, which is past. In order of time for each outlet.
  std::function<void(std::size_t outlet, std::int64_t step, bool closed)> on_edge = {};
  // The next steps at the outlets' terminals, from step 0 on.
  std::function<void(const float* voltage_pu, std::size_t count)> on_voltage = {};
};

class Wire {
 public:
  // Connects the terminals at step 0 of `time`, and starts a thread that brings the outlets up to
  // now about every 2 ms. It renders the output from step 0 on. `terminals` and `output` must
  // outlive the wire; nobody else may use the terminals meanwhile.
  Wire(Terminals& terminals, Output& output, const TrueTime& time, const WireOptions& options);
  // Ends the thread. Blocks for a few ms.
  ~Wire();
  Wire(const Wire&) = delete;
  Wire& operator=(const Wire&) = delete;

  // May be called from any thread.
  std::int64_t step() const { return step_; }  // the outlets have received the steps before it
  // Now, in true time.
  bool contact_closed(std::size_t outlet) const;
  // How long after it happened an edge of a contact became known, s, at worst so far. 0 as long as
  // the outlets' processes keep up with true time, because a contact follows its coil after 6 ms.
  double worst_lateness_s() const;

 private:
  void run();
  void bring_up_to(std::int64_t now_step);
  void look_ahead();
  void pass_edges();
  void filter();

  Terminals& terminals_;
  Output& output_;
  TrueTime time_;
  WireOptions options_;
  // One section in direct form II transposed: the numerator is b0·(1 + 2/z + 1/z²).
  double b0_ = 0.0;
  double a1_ = 0.0;
  double a2_ = 0.0;
  double z1_ = 0.0;
  double z2_ = 0.0;
  std::vector<float> voltage_;
  std::vector<models::ContactEdge> edges_;
  struct Contact {
    std::deque<models::ContactEdge> ahead;  // known edges that were not passed yet, ascending
    bool closed = true;                     // before them
  };
  mutable std::mutex contacts_mutex_;
  std::vector<Contact> contacts_;  // under contacts_mutex_
  std::atomic<std::int64_t> step_{0};
  std::atomic<std::int64_t> worst_lateness_steps_{0};
  std::atomic<bool> ending_{false};
  std::thread thread_;  // last: it uses the others
};

}  // namespace gsbench::emulation

// Runs on the emulated Cortex-M4F: calls the image's estimator for many trajectories. The debugger
// loads this code beside the image; the image's functions are called by address.
#include "calls.hpp"

#include <outlet/estimator.hpp>

namespace {

template <class T>
T at(std::uint32_t address) {
  return reinterpret_cast<T>(address);
}

}  // namespace

extern "C" void make_calls(const gs::test::Calls& calls) {
  using gs::outlet::EstimatorState;
  // Interrupts off: the firmware must not run meanwhile.
  asm volatile("cpsid i" ::: "memory");
  const auto begin = at<decltype(&gs::outlet::begin)>(calls.begin);
  const auto observe = at<decltype(&gs::outlet::observe)>(calls.observe);
  const auto& settings = *at<const gs::outlet::Settings*>(calls.settings);
  const auto& line = *at<const gs::outlet::Line*>(calls.line);
  const auto* deviation_hz = at<const float*>(calls.deviations_hz);
  auto* state = at<EstimatorState*>(calls.states);
  for (std::uint32_t number = 0; number < calls.trajectories; ++number, ++state) {
    begin(*state, calls.baseline);
    for (std::uint32_t k = 0; k < calls.samples; ++k, ++deviation_hz) {
      observe(settings, calls.nominal_hz, *state, true, *deviation_hz, line);
    }
  }
}

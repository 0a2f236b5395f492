#include <app/self_test.hpp>
#include <outlet/crc32.hpp>
#include <outlet/estimator.hpp>
#include <outlet/settings.hpp>

namespace gs::app {
namespace {

constexpr float kNominalHz = 50.0f;

void add_bits(outlet::Crc32& crc, float value) {
  std::uint32_t bits = 0;
  __builtin_memcpy(&bits, &value, sizeof bits);
  for (int shift = 0; shift < 32; shift += 8) {
    crc.add(static_cast<std::uint8_t>(bits >> shift));
  }
}

}  // namespace

std::uint32_t arithmetic_fingerprint() {
  // Of a system much like the modified IEEE 24-bus one; the numbers only have to be the same
  // everywhere. Without the front end, whose tables would not fit into an outlet's memory twice.
  outlet::Settings settings;
  settings.response = {9.13e-4f, 0.2993f, 0.0682f, 1.262f};
  settings.largest_loss_mw = 2745.0f;
  settings.loss_sigma_mw = 88.0f;
  outlet::EstimatorState state;
  outlet::begin(state, {50.0f, 0.0f});
  outlet::Crc32 crc;
  float frequency_hz = 49.98f;
  std::uint32_t ripple = 1;
  for (int report = 0; report < 60; ++report) {
    ripple = ripple * 1664525u + 1013904223u;
    const float noise_hz = (static_cast<float>(ripple >> 8) * 5.9604645e-8f - 0.5f) * 0.01f;
    frequency_hz -= 0.0075f - 0.00008f * static_cast<float>(report);
    outlet::observe(settings, kNominalHz, state, true, frequency_hz + noise_hz,
                    {frequency_hz, -0.45f});
    add_bits(crc, state.lse_loss_mw);
    add_bits(crc, state.ekf.loss_mw);
    add_bits(crc, outlet::loss_sigma_mw(state));
    add_bits(crc, outlet::loss_instant_s(state));
  }
  return crc.value();
}

}  // namespace gs::app

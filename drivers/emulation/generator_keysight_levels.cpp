// The amplitude of a Keysight: in three units, or by its highest and lowest voltage.
#include "generator_keysight.hpp"

#include <cmath>

namespace gsbench::emulation {

// dBm needs a load; into high impedance, it becomes Vpp by itself (guide, VOLTage:UNIT).
std::string_view Keysight::unit() const {
  return unit_ == "DBM" && std::isinf(state_.settings().load_ohm) ? "VPP" : unit_;
}

// RMS of full-scale sine, square and ramp; others are set peak to peak only.
double Keysight::volts_of(double amplitude) const {
  const GeneratorSettings& now = state_.settings();
  const double crest = now.function == GeneratorFunction::kSine     ? std::sqrt(2.0)
                       : now.function == GeneratorFunction::kSquare ? 1.0
                                                                    : std::sqrt(3.0);
  if (unit() == "VRMS") {
    return 2 * crest * amplitude;
  }
  if (unit() == "DBM") {
    return 2 * crest * std::sqrt(1e-3 * std::pow(10, amplitude / 10) * now.load_ohm);
  }
  return amplitude;
}

double Keysight::amplitude_of(double vpp) const {
  const double one_v = unit() == "DBM" ? 1.0 : volts_of(1.0);
  if (unit() == "DBM") {
    const double zero_dbm = volts_of(0.0);
    return 20 * std::log10(vpp / zero_dbm);
  }
  return vpp / one_v;
}

void Keysight::set_levels(double low_v, double high_v) {
  const double lowest = state_.lowest_vpp();
  const double peak = state_.highest_peak_v();
  if (high_v - low_v < lowest * (1 - 1e-9) || high_v > peak || low_v < -peak) {
    error(-222, "Data out of range");
    return;
  }
  change([&](GeneratorSettings& next) {
    next.amplitude_vpp = high_v - low_v;
    next.offset_v = (high_v + low_v) / 2;
  });
}

void Keysight::add_levels() {
  add(
      "[SOURce:]VOLTage[:LEVel][:IMMediate][:AMPLitude]",
      [this](std::string_view argument) {
        const double highest = state_.highest_vpp(state_.settings().offset_v);
        number(argument, amplitude_of(state_.lowest_vpp()), amplitude_of(highest),
               [this](double value) {
                 const double vpp = volts_of(value);
                 change([&](GeneratorSettings& next) { next.amplitude_vpp = vpp; });
               });
      },
      [this](std::string_view) { return written(amplitude_of(state_.settings().amplitude_vpp)); });
  add(
      "[SOURce:]VOLTage:UNIT",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"VPP", "VRMS", "DBM"});
        if (name == "DBM" && std::isinf(state_.settings().load_ohm)) {
          error(-221, "Settings conflict; dBm needs a finite load");
        } else if (!name.empty()) {
          unit_ = name;
        }
      },
      [this](std::string_view) { return std::string(unit()); });
  add_number("[SOURce:]VOLTage[:LEVel][:IMMediate]:OFFSet", &GeneratorSettings::offset_v,
             offsets());
  const auto low = [this] {
    return state_.settings().offset_v - state_.settings().amplitude_vpp / 2;
  };
  const auto high = [this] {
    return state_.settings().offset_v + state_.settings().amplitude_vpp / 2;
  };
  add(
      "[SOURce:]VOLTage[:LEVel][:IMMediate]:HIGH",
      [this, low](std::string_view argument) {
        const double peak = state_.highest_peak_v();
        number(argument, -peak, peak, [&](double value) { set_levels(low(), value); });
      },
      [this, high](std::string_view) { return written(high()); });
  add(
      "[SOURce:]VOLTage[:LEVel][:IMMediate]:LOW",
      [this, high](std::string_view argument) {
        const double peak = state_.highest_peak_v();
        number(argument, -peak, peak, [&](double value) { set_levels(value, high()); });
      },
      [this, low](std::string_view) { return written(low()); });
}

}  // namespace gsbench::emulation

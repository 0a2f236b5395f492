// The dialect of the Keysight 33500B. Source: Agilent/Keysight 33500 Series Operating and Service
// Guide (33500-90901), section SCPI programming reference. Numbers of errors above 0 are those of
// the 33220A's list where it has the same text; that of a name that is loaded is not verified.
#pragma once

#include "generator_scpi_dialect.hpp"

#include <string>
#include <string_view>

namespace gsbench::emulation {

class Keysight : public ScpiDialect {
 public:
  explicit Keysight(GeneratorState& state);
  void lose_power() override;

 private:
  void add_output();
  void add_wave();
  void add_levels();
  void add_arbitrary();
  void add_data();
  void add_burst();
  void set_function(std::string_view argument);
  void apply(std::string_view shape, std::string_view argument);
  void set_levels(double low_v, double high_v);
  void select(std::string_view argument);
  void take_data(std::string_view argument, bool dac);
  std::string_view shape() const;
  std::string_view unit() const;
  double volts_of(double amplitude) const;  // in the unit chosen, to peak to peak
  double amplitude_of(double vpp) const;

  std::string written(double value) const override;
  std::string written(bool on) const override { return on ? "1" : "0"; }
  std::optional<double> out_of_range(double limit) override;
  std::int64_t complete() const override;
  void trigger() override;
  void reset() override;

  std::string_view shape_ = "SINusoid";
  std::string_view unit_ = "VPP";
  std::string_view filter_ = "STEP";
  bool swapped_ = false;  // FORMat:BORDer SWAP: little endian
};

}  // namespace gsbench::emulation

// The dialect of the Rigol DG1000Z. Sources: DG1000Z Programming Guide (Rigol, 2013 and later), and
// public drivers and their tests; what only users report says so.
#pragma once

#include "generator_scpi_dialect.hpp"

#include <string>
#include <vector>

namespace gsbench::emulation {

class Rigol : public ScpiDialect {
 public:
  static constexpr int kHighestCode = 0x3fff;

  explicit Rigol(GeneratorState& state);
  void lose_power() override;
  void arrived(std::int64_t step) override { arrived_ = step; }

 private:
  void add_output();
  void add_wave();
  void add_burst();
  void add_idle();
  void add_data();
  void apply(GeneratorFunction function, std::string_view argument);
  void take_packet(std::string_view argument);
  void take_values(std::string_view argument);
  void end_upload(std::vector<std::int16_t> codes);

  std::string written(double value) const override;
  std::string written(bool on) const override { return on ? "ON" : "OFF"; }
  std::optional<double> out_of_range(double limit) override;
  std::int64_t ready_for_query() const override { return busy_until_; }
  std::int64_t complete() const override { return busy_until_; }
  void trigger() override;
  void reset() override;

  std::vector<std::int16_t> packets_;  // before END
  std::int64_t arrived_ = 0;
  std::int64_t busy_until_ = std::numeric_limits<std::int64_t>::min();
  std::string idle_ = "FPT";
};

}  // namespace gsbench::emulation

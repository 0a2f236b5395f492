// The dialect of the Siglent SDG1000X and SDG2000X: "C1:BSWV FRQ,1000,AMP,4", pairs of names and
// values, no errors. Sources: Siglent SDG Series Programming Guide PG02-E05C, and public drivers
// whose authors recorded the answers of an SDG1032X (firmware 1.01.01.33R1B6, USB and TCP) and of
// an SDG2042X (firmware 2.01.01.23R7, VXI-11). Where the two disagree with the guide, the
// instruments count.
#pragma once

#include "generator_dialect.hpp"

#include <string>
#include <string_view>

namespace gsbench::emulation {

class Siglent : public GeneratorDialect {
 public:
  Siglent(GeneratorState& state, bool sample_rates) : state_(state), has_rates_(sample_rates) {}

  std::size_t message_size(std::string_view bytes) override;
  std::size_t text_size(std::string_view message) const override;
  void connect() override { scanned_ = 0; }
  void lose_power() override;
  GeneratorReply execute(std::string_view message) override;

 private:
  std::string answer(const std::string& header, std::string_view argument) const;
  void set(const std::string& header, std::string_view argument);
  void set_wave(std::string_view argument);
  void set_output(std::string_view argument);
  void set_rate(std::string_view argument);
  void set_burst(std::string_view argument);
  void select(std::string_view argument);
  void store(std::string_view argument);
  std::string wave() const;
  std::string carrier() const;
  std::string burst() const;
  std::string read_back(std::string_view argument) const;
  double frequency_hz() const;

  GeneratorState& state_;
  const bool has_rates_;
  std::size_t scanned_ = 0;
  bool swallows_next_ = false;
  bool infinite_ = false;
};

}  // namespace gsbench::emulation

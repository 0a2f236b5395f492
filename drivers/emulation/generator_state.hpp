// What an emulated generator knows: settings, waveforms, faults. The dialects of the makers change
// it; it drives the output stage. Not thread-safe: its owner locks.
#pragma once

#include "generator_player.hpp"
#include "generator_waveform.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <emulation/generator.hpp>

namespace gsbench::emulation {

// What distinguishes the models, whatever their dialect.
struct GeneratorFacts {
  std::string identity;         // the answer to *IDN?
  int dropped_bits;             // the lowest ones of uploaded codes, which the DAC does not have
  std::size_t fewest_points;    // of a waveform
  std::size_t most_points;      // of a waveform
  std::size_t memory_points;    // of all waveforms
  std::size_t table_points;     // that kFrequency plays a waveform from; 0: plays it as it is
  double highest_rate_hz;       // of samples; 0: no kSampleRate
  double highest_frequency_hz;  // of a sine
  double highest_arbitrary_hz;  // of an arbitrary waveform
  bool keeps_waveforms;         // without power
  GeneratorSettings defaults;   // after power-on and *RST
};

const GeneratorFacts& facts_of(GeneratorModel model);

class GeneratorState {
 public:
  explicit GeneratorState(const GeneratorOptions& options);

  const GeneratorFacts& facts() const { return facts_; }
  const TrueTime& time() const { return options_.time; }
  double packet_pause_s() const { return options_.packet_pause_s; }
  const GeneratorSettings& settings() const { return settings_; }
  const GeneratorFaults& faults() const { return faults_; }
  void set_faults(const GeneratorFaults& faults) { faults_ = faults; }
  GeneratorPlayer& player() { return player_; }
  const GeneratorPlayer& player() const { return player_; }

  // Replaces the settings, except that a change of load_ohm alone keeps the voltage at the output:
  // the displayed voltages change (use set_load()). Burst and function changes restart the output.
  void set(const GeneratorSettings& settings);
  void set_load(double load_ohm);
  void set_idle(std::optional<double> idle);
  void restart();  // plays from the start, or waits for a trigger
  void reset();    // *RST
  void lose_power();

  // Limits of the displayed voltages: 10 V peak into an open circuit, 1 mV peak to peak into 50 Ω
  // for all four models (data sheets).
  double lowest_vpp() const;
  double highest_vpp(double offset_v) const;
  double highest_peak_v() const;  // offset and half the amplitude together
  double highest_frequency_hz(GeneratorFunction function) const;

  bool has_room(std::size_t points) const;
  void store(GeneratorWaveform waveform);  // replaces one of the same name
  const GeneratorWaveform* find(const std::string& name) const;
  std::vector<std::string> names() const;
  void forget_waveforms();

 private:
  void play(bool restart);
  std::shared_ptr<const GeneratorWaveform> played_waveform() const;
  double rate_hz(const GeneratorWaveform& waveform) const;  // whole waveforms a second

  GeneratorOptions options_;
  const GeneratorFacts& facts_;
  GeneratorSettings settings_;
  std::optional<double> idle_;
  GeneratorFaults faults_;
  std::map<std::string, std::shared_ptr<const GeneratorWaveform>> waveforms_;
  // What the DAC plays: derived from the selected waveform, and kept as long as it is selected.
  mutable std::shared_ptr<const GeneratorWaveform> selected_, derived_;
  mutable PointRate derived_for_ = PointRate::kFrequency;
  GeneratorPlayer player_;
};

}  // namespace gsbench::emulation

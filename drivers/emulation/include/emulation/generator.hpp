// An emulated waveform generator with one output, behind a TCP port. It keeps state, follows the
// syntax of its maker and has the faults of the real instrument, as far as manuals and users
// describe them. drivers/emulation/generator_*.cpp names the source of each behaviour.
//
// Voltages of settings are as displayed: into the load that the instrument is set for. The output
// has 50 Ω. By default, only a high-impedance amplifier is connected to it, so that a generator
// that is set for a load of 50 Ω gives twice the displayed voltage.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <emulation/output.hpp>

namespace gsbench::emulation {

enum class GeneratorModel : std::uint8_t { kSdg1032x, kSdg2042x, kDg1062z, k33522b };

struct GeneratorOptions {
  GeneratorModel model = GeneratorModel::kSdg2042x;
  double clock_ppm = 0.0;  // error of its time base; positive: fast
  TrueTime time;           // shared by all emulated devices of a station
  // Of a Rigol: a packet of a waveform is lost if it arrives earlier after the one before.
  double packet_pause_s = 0.05;
  double connected_ohm = std::numeric_limits<double>::infinity();  // load at its output
};

// Deviations from what a working instrument does. The default is none.
struct GeneratorFaults {
  bool silent = false;            // executes commands and answers nothing
  double answer_delay_s = 0.0;    // each answer, and what follows it, waits so long
  double receive_bytes_s = 0.0;   // takes bytes from the network so slowly; 0: at once
  bool half_answers = false;      // sends the first half of the next answer, then nothing more
  bool garbage_answers = false;   // answers have other bytes, of the same length
  int drop_at_message = 0;        // closes the connection instead of executing the n-th message
                                  // from now on (1: the next); 0: never
  std::size_t drop_at_byte = 0;   // closes the connection when it has received so many bytes from
                                  // now on, such as within a block; 0: never
  bool error_queue_full = false;  // fills the queue, if the model has one, when it is set
  bool memory_full = false;       // has no room for one more waveform
  std::optional<double> silent_limit_vpp;  // clamps higher amplitudes and reports no error
  bool ignores_output_off = false;         // as with a stuck relay
  bool upload_switches_on = false;         // a complete upload switches the output on
  std::string identity;                    // the answer to *IDN?; empty: that of the model
};

enum class GeneratorFunction : std::uint8_t {
  kSine,
  kSquare,
  kRamp,
  kPulse,
  kNoise,
  kDc,
  kArbitrary
};

enum class PointRate : std::uint8_t {
  kFrequency,   // the whole waveform is played so many times a second
  kSampleRate,  // so many points a second
};

enum class Between : std::uint8_t { kHold, kLine };  // between two points

enum class TriggerSource : std::uint8_t { kInternal, kExternal, kManual };  // kManual: also a bus

// The settings of the output, in the units of the front panel.
struct GeneratorSettings {
  bool output_on = false;
  GeneratorFunction function = GeneratorFunction::kSine;
  double frequency_hz = 1000.0;
  double amplitude_vpp = 1.0;  // into load_ohm
  double offset_v = 0.0;       // into load_ohm
  double phase_deg = 0.0;
  double duty_pct = 50.0;      // of a square or pulse
  double symmetry_pct = 50.0;  // of a ramp: the rising part
  double load_ohm = 50.0;      // that it is set for; infinite: high impedance
  bool inverted = false;
  std::string waveform;  // the arbitrary waveform selected; empty: a built-in one, 0 V here
  PointRate point_rate = PointRate::kFrequency;
  double sample_rate_hz = 1e6;  // of kSampleRate
  Between between = Between::kHold;
  bool burst_on = false;
  double burst_cycles = 1.0;  // infinite: until the burst is switched off
  TriggerSource trigger = TriggerSource::kInternal;
  double burst_period_s = 0.01;  // of kInternal
};

// What is changed at the front panel; the rest stays.
struct PanelChange {
  std::optional<bool> output_on;
  std::optional<GeneratorFunction> function;
  std::optional<double> frequency_hz;
  std::optional<double> amplitude_vpp;
  std::optional<double> offset_v;
  std::optional<double> load_ohm;
  std::optional<double> sample_rate_hz;
  std::optional<bool> burst_on;
};

class GeneratorCore;

// All functions may be called from any thread, but render() from one only. The instrument also
// works without render(): its output is then not observed.
class Generator : public Output {
 public:
  // An error if no port is free.
  static drivers::Result<std::unique_ptr<Generator>> start(const GeneratorOptions& options);
  ~Generator() override;
  Generator(const Generator&) = delete;
  Generator& operator=(const Generator&) = delete;

  // For transport/transport.hpp, such as "tcp://127.0.0.1:40001". Messages end with a newline. One
  // client is served at a time; a second one waits, connected, until the first has gone.
  std::string port() const;

  void render(std::int64_t first_step, std::size_t count, float* volts) override;

  // For tests. Settings and output_is_on() are those that the next command will find.
  bool output_is_on() const;
  GeneratorSettings settings() const;
  // Codes of a stored waveform, −32 767 … 32 767 as full scale whatever the instrument's format;
  // none if there is no waveform of this name.
  std::optional<std::vector<std::int16_t>> waveform(const std::string& name) const;
  // Whether a burst is being played at the time of the shared clock.
  bool is_playing() const;
  // The messages received, without terminators and bytes of waveforms; 200 characters of each.
  std::vector<std::string> messages() const;
  void clear_messages();

  // For fault injection.
  void set_faults(const GeneratorFaults& faults);
  // Calls `then`, once, when the n-th message from now on has arrived (1: the next), before it is
  // executed. From the emulator's thread; `then` calls no function of this object.
  void at_message(int message, std::function<void()> then);
  void press(const PanelChange& change);
  // Cuts the power and switches on again. The connection closes and new ones are refused for
  // `starting_up`. Output off, settings at their defaults, volatile waveforms lost. Does not wait.
  void reset_now(std::chrono::milliseconds starting_up);
  // The network cable. The instrument goes on playing.
  void unplug();
  [[nodiscard]] drivers::Status plug_in();

 private:
  explicit Generator(std::unique_ptr<GeneratorCore> core);

  std::unique_ptr<GeneratorCore> core_;
};

}  // namespace gsbench::emulation

#include "emulated_instrument.hpp"

#include <fcntl.h>
#include <relay_modem_line/modem_line_sense.hpp>
#include <sys/ioctl.h>

#include <cerrno>
#include <map>
#include <mutex>
#include <stdexcept>

#include <emulation/head_emulator.hpp>

namespace gsbench::station {
namespace {

// A contact that became known later than this was not on its modem line in time.
constexpr double kMostLate_s = 0.002;
constexpr const char* kByHostClock = "this machine's clock, to which the source's start is known";
constexpr const char* kLine = "emulated modem line ";

template <class Made>
auto made_or_throw(Made made) {
  if (!made.ok()) {
    throw std::runtime_error("the emulated instrument: " + made.error());
  }
  return made.take();
}

// Serial adapters with one contact each, at CTS.
class EmulatedLines {
 public:
  explicit EmulatedLines(const emulation::Wire& wire) : wire_(wire) {}

  drivers::Result<drivers::Descriptor> open(const std::string& port) {
    drivers::Descriptor descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC));
    const std::lock_guard<std::mutex> lock(mutex_);
    outlets_[descriptor.get()] = std::stoul(port.substr(std::string(kLine).size()));
    return descriptor;
  }

  int ioctl(int descriptor, unsigned long request, int* bits) {
    if (request != TIOCMGET) {
      return 0;
    }
    // Better no relay sense than a wrong one: this happens if outlets' processes starve.
    if (wire_.worst_lateness_s() > kMostLate_s) {
      errno = ETIME;
      return -1;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    *bits = wire_.contact_closed(outlets_.at(descriptor)) ? TIOCM_CTS : 0;
    return 0;
  }

 private:
  const emulation::Wire& wire_;
  std::mutex mutex_;
  std::map<int, std::size_t> outlets_;  // by descriptor
};

std::shared_ptr<relay::RelaySense> modem_line_sense(const emulation::Wire& wire,
                                                    const source::Source& source,
                                                    std::size_t outlets,
                                                    std::int64_t sample_rate_hz) {
  relay::ModemLineOptions options;
  options.sample_rate_hz = sample_rate_hz;
  for (std::size_t i = 0; i < outlets; ++i) {
    options.contacts.push_back({kLine + std::to_string(i), relay::ModemLine::kCts});
  }
  const auto lines = std::make_shared<EmulatedLines>(wire);
  relay::ModemLineSystem system = relay::this_machine();
  system.open = [lines](const std::string& port) { return lines->open(port); };
  system.ioctl = [lines](int descriptor, unsigned long request, int* bits) {
    return lines->ioctl(descriptor, request, bits);
  };
  return std::make_shared<relay::ModemLineSense>(options, source, system);
}

}  // namespace

EmulatedInstrument::EmulatedInstrument(const InstrumentOptions& options, const profile::Plan& plan,
                                       const PlayedSignal& signal, emulation::Hardware& hardware)
    : options_(options) {
  emulation::WireOptions wire;
  wire.gain = options.settings.gain;
  wire.nominal_v = options.settings.nominal_v;
  wire.seed = plan.seed;
  emulation::HeadEmulator* head = nullptr;
  if (options.generator) {
    auto generator =
        made_or_throw(emulation::Generator::start({*options.generator, options.clock_ppm, time_}));
    port_ = generator->port();
    emulator_ = std::move(generator);
  } else {
    emulation::HeadEmulatorOptions head_options;
    head_options.clock_ppm = options.clock_ppm;
    auto made = made_or_throw(emulation::HeadEmulator::create(head_options));
    port_ = made->port();
    head = made.get();
    emulator_ = std::move(made);
  }
  options_.settings.tolerances = plan.stimulus.tolerances;
  driver_ = options_.make_source(port_, options_.settings);
  if (options.sense == EmulatedSense::kHead) {
    for (std::size_t i = 0; i < hardware.outlets().size(); ++i) {
      head->set_input(i, 0, true);
    }
    wire.on_edge = [head](std::size_t outlet, std::int64_t step, bool closed) {
      head->set_input(outlet, step, closed);
    };
    sense_ = driver_.relay_sense;
    relay_aligned_by_ = "counts the head's samples";
  } else if (options.sense == EmulatedSense::kTerminals) {
    const auto sense = std::make_shared<emulation::TerminalSense>(signal, *driver_.source,
                                                                  options.clock_ppm, time_);
    wire.on_edge = [sense](std::size_t outlet, std::int64_t step, bool closed) {
      sense->moved(outlet, step, closed);
    };
    wire.on_voltage = [sense](const float* voltage_pu, std::size_t count) {
      sense->seen(voltage_pu, count);
    };
    sense_ = sense;
    relay_aligned_by_ =
        sense->is_aligned_by_dips() ? "dips of the voltage at the terminals" : kByHostClock;
  }
  wire_ = std::make_unique<emulation::Wire>(hardware.outlets(), *emulator_, time_, wire);
  if (options.sense == EmulatedSense::kModemLine) {
    sense_ = modem_line_sense(*wire_, *driver_.source, hardware.outlets().size(),
                              plan.stimulus.sample_rate_hz);
    relay_aligned_by_ = kByHostClock;
  }
}

EmulatedInstrument::~EmulatedInstrument() {
  if (options_.sense == EmulatedSense::kModemLine) {
    sense_.reset();  // it reads the wire
  }
  wire_.reset();  // it calls the others
}

}  // namespace gsbench::station

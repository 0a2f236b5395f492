// Relay sense on modem lines of serial adapters: a relay contact connects an output of the adapter
// (RTS or DTR, both switched on by open()) with CTS, DSR or DCD. The line is on while the contact
// is closed. A contact that carries mains needs an opto-coupler or an auxiliary contact.
//
// A thread for each port reads the lines about every 1 ms (TIOCMGET). TIOCMIWAIT, which waits for a
// change, is not used: some drivers of USB adapters do not support it, it cannot be interrupted
// safely, and it does not report the time of the change either.
//
// An edge lies between the start of the last reading that did not see it and the end of the first
// one that did. It is stamped with the middle, on this machine's steady clock. Its uncertainty is
// half of that interval, which grows if the machine was busy, plus `adapter_latency_s`, plus the
// uncertainty of the source's ticks on the same clock (Source::host_clock()). Bounces that are
// shorter than the interval are not seen.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <drivers/descriptor.hpp>
#include <drivers/result.hpp>
#include <relay/relay_sense.hpp>
#include <source/source.hpp>

namespace gsbench::relay {

enum class ModemLine : std::uint8_t { kCts, kDsr, kDcd };

struct ModemLineContact {
  std::string port;  // "/dev/ttyUSB0"; several contacts may be on one port
  ModemLine line = ModemLine::kCts;
};

// The calls of the operating system, to be replaced where there is no adapter. `ioctl` and the
// clock are called from several threads.
struct ModemLineSystem {
  // Opens a serial port for its modem lines alone.
  std::function<drivers::Result<drivers::Descriptor>(const std::string& port)> open;
  // Like ioctl(2) with TIOCMGET and TIOCMBIS: −1 with errno is an error.
  std::function<int(int descriptor, unsigned long request, int* bits)> ioctl;
  std::function<std::chrono::steady_clock::time_point()> now;
  std::function<void(std::chrono::steady_clock::duration)> sleep;
};
ModemLineSystem this_machine();

struct ModemLineOptions {
  std::vector<ModemLineContact> contacts;  // channel i is contacts[i]
  std::int64_t sample_rate_hz = 8000;      // of the stimulus
  // How old the state that TIOCMGET returns may be. Full-speed USB adapters transfer changes with
  // the next poll of their interrupt endpoint, every 1 ms.
  double adapter_latency_s = 0.001;
};

class ModemLineSense final : public RelaySense {
 public:
  // `source` must outlive this object, and be used from the same thread.
  ModemLineSense(const ModemLineOptions& options, const source::Source& source,
                 ModemLineSystem system = this_machine());
  // Ends the threads. Blocks for a few ms.
  ~ModemLineSense() override;

  // Opens the ports, switches RTS and DTR on and starts to read; does nothing if that was done.
  // Returns an error if a port cannot be opened or has no modem lines.
  [[nodiscard]] drivers::Status open() override;

  // Counts are nanoseconds of the steady clock, from this object's creation on.
  // `uncertainty_ticks` is the largest one of the edges polled so far; before the first one, that
  // of readings 1 ms apart. The source's part is known from its start on; before, it is that of
  // source::Limits.
  Alignment alignment() const override;
  std::string not_known_yet() const override;
  std::optional<std::int64_t> count_at(std::chrono::steady_clock::time_point time) const override;
  // An error once a port has been lost, such as an adapter that was unplugged.
  drivers::Status poll(std::vector<Edge>& edges) override;

 private:
  class Port;

  ModemLineOptions options_;
  const source::Source& source_;
  ModemLineSystem system_;
  std::chrono::steady_clock::time_point epoch_;
  double largest_half_s_;
  bool is_open_ = false;
  std::vector<std::unique_ptr<Port>> ports_;
};

}  // namespace gsbench::relay

// Board of an outlet that runs as a process on this machine. A mapped file, the terminals, replaces
// the ADC, the relay coil and the flash. A line replaces the radio or the UART.
#pragma once

#include "line.hpp"
#include <shared_memory_io/shared_port.hpp>

#include <string>

#include <superloop/board.hpp>

namespace gs::host {

class HostBoard final : public superloop::Board {
 public:
  HostBoard(shared_memory_io::SharedMemory& terminals, Line& line)
      : port_(terminals), line_(line) {}
  ~HostBoard();
  HostBoard(const HostBoard&) = delete;
  HostBoard& operator=(const HostBoard&) = delete;

  // Connects to the doorbell, a socket on which the bench sends a byte after each block of samples.
  // If the connection fails, returns false with the reason in `why`.
  bool start(const std::string& doorbell, std::string& why);
  // Starts without a bench: this process writes the samples, after each wait().
  void start_alone();

  // Blocks until samples or bytes arrive, at most a tenth of a second; without a bench 4 ms.
  // Returns false if the bench has closed the doorbell.
  bool wait();

  bool send(const std::uint8_t* bytes, std::size_t count) override {
    return line_.send(bytes, count);
  }
  std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) override {
    return port_.take_samples(out, most, lost);
  }
  bool take_byte(std::uint8_t& byte) override { return line_.take_byte(byte); }
  void drive_relay(bool closed) override { port_.drive_relay(closed); }
  void feed_watchdog() override {}
  bool adc_idle() const override { return !port_.samples_wait(); }

 private:
  shared_memory_io::SharedPort port_;
  Line& line_;
  int doorbell_ = -1;
};

// Maps a terminals file. If the file cannot be opened or is of another kind, returns null with the
// reason in `why`.
shared_memory_io::SharedMemory* map_terminals(const std::string& path, std::string& why);

}  // namespace gs::host

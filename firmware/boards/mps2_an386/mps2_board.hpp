// ARM's MPS2 with AN386, as emulated by qemu. The terminals (shared_memory_io/shared_memory.hpp)
// are in its PSRAM.
#pragma once

#include <shared_memory_io/shared_port.hpp>

#include <queues/queues.hpp>

#include <superloop/board.hpp>

namespace gs::mps2_an386 {

class Mps2Board final : public superloop::Board {
 public:
  explicit Mps2Board(shared_memory_io::SharedMemory& terminals)
      : terminals_(terminals), port_(terminals) {}

  // Starts the link, the watchdog and the doorbell (a UART on which the bench announces samples).
  // Skips samples written before this call. The bench must have written the terminals.
  void start();
  void sleep();

  bool send(const std::uint8_t* bytes, std::size_t count) override;
  std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) override;
  bool take_byte(std::uint8_t& byte) override;
  void drive_relay(bool closed) override { port_.drive_relay(closed); }
  void feed_watchdog() override;
  // True if no samples wait. Also true while the link's send buffer is nearly full and at most half
  // a ring of samples waits. The outlet can pause because its time is its sample count: samples may
  // arrive faster than real time, and the link may fall behind. If more than half a ring waits, the
  // outlet takes samples again, and messages that do not fit are dropped, as on a real board.
  bool adc_idle() const override;

  void on_receive();
  void on_transmit();

 private:
  void pump();

  const shared_memory_io::SharedMemory& terminals_;
  shared_memory_io::SharedPort port_;
  queues::ByteRing<512> received_;
  queues::ByteRing<1024> to_send_;
};

// True if the watchdog caused this start; true only for the first call.
bool reset_by_watchdog();
// Handler of the watchdog's interrupt. The interrupt warns of the reset: it comes when half the
// time from the last feed to the reset has passed.
void note_watchdog();

}  // namespace gs::mps2_an386

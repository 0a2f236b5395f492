// ARM's MPS2 with AN386, as qemu emulates it, with the terminals of
// shared_memory_io/shared_memory.hpp in its PSRAM.
#pragma once

#include <shared_memory_io/shared_port.hpp>

#include <superloop/board.hpp>
#include <superloop/queues.hpp>

namespace gs::mps2_an386 {

class Mps2Board final : public superloop::Board {
 public:
  explicit Mps2Board(shared_memory_io::SharedMemory& terminals)
      : terminals_(terminals), port_(terminals) {}

  // After the terminals are written: link, doorbell and watchdog run, the mains is followed from
  // its newest sample on.
  void start();
  void sleep();

  bool send(const std::uint8_t* bytes, std::size_t count) override;
  std::size_t take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) override;
  bool take_byte(std::uint8_t& byte) override;
  void drive_relay(bool closed) override { port_.drive_relay(closed); }
  void feed_watchdog() override;
  // The samples are this outlet's time. Where the link falls behind, as it does when they come
  // faster than real time, they wait, up to half a ring; beyond, messages are dropped as on a real
  // board.
  bool adc_idle() const override;

  void on_receive();
  void on_transmit();

 private:
  void pump();

  const shared_memory_io::SharedMemory& terminals_;
  shared_memory_io::SharedPort port_;
  superloop::ByteRing<512> received_;
  superloop::ByteRing<1024> to_send_;
};

// The watchdog ran out before this start, though power stayed on. Told once.
bool watchdog_barked();
// From its first warning, half a period before it resets.
void note_watchdog();

}  // namespace gs::mps2_an386

// The link of a board: USART1, PA9 TX and PA10 RX, 921 600 baud. Bytes pass through buffers that an
// interrupt fills and empties.
#pragma once

#include <cstddef>
#include <cstdint>

#include <queues/queues.hpp>

namespace gs::stm32f405 {

class UsartLink {
 public:
  // The clocks of port A and USART1 must be on.
  void start(std::uint32_t apb2_hz);

  // Takes all bytes, or none if they do not fit; does not block.
  bool send(const std::uint8_t* bytes, std::size_t count);
  std::size_t room() const { return to_send_.room(); }
  // Returns false if no byte has arrived.
  bool take(std::uint8_t& byte) { return received_.take(byte); }
  bool has_received() const { return received_.used() > 0; }

  void on_interrupt();

 private:
  void pump();

  queues::ByteRing<512> received_;
  queues::ByteRing<1024> to_send_;
};

}  // namespace gs::stm32f405

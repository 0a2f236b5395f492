#include <cortex_m4/core.hpp>
#include <stm32f405_chip/chip.hpp>
#include <stm32f405_chip/usart_link.hpp>

namespace gs::stm32f405 {
namespace {

constexpr std::uint32_t kBaud = 921'600;
constexpr unsigned kTxPin = 9, kRxPin = 10;  // of port A
constexpr std::uint32_t kUsartFunction = 7;

}  // namespace

void UsartLink::start(std::uint32_t apb2_hz) {
  set_function(*GPIOA, kTxPin, kUsartFunction);
  set_function(*GPIOA, kRxPin, kUsartFunction);
  USART1->BRR = (apb2_hz + kBaud / 2) / kBaud;
  USART1->CR1 = USART_CR1_UE | USART_CR1_TE | USART_CR1_RE | USART_CR1_RXNEIE;
  cortex_m4::enable_interrupt(kUsart1Irq);
}

bool UsartLink::send(const std::uint8_t* bytes, std::size_t count) {
  const cortex_m4::InterruptsMasked masked;
  const bool taken = to_send_.put(bytes, count);
  pump();
  return taken;
}

void UsartLink::on_interrupt() {
  // Reading DR after SR also clears an overrun. Its frame is reported as bad.
  while ((USART1->SR & (USART_SR_RXNE | USART_SR_ORE)) != 0) {
    received_.put(static_cast<std::uint8_t>(USART1->DR));
  }
  pump();
}

// Writes what the transmitter takes now; its interrupt requests the rest.
void UsartLink::pump() {
  std::uint8_t byte = 0;
  while ((USART1->SR & USART_SR_TXE) != 0 && to_send_.take(byte)) {
    USART1->DR = byte;
  }
  const std::uint32_t receiving = USART1->CR1 & ~USART_CR1_TXEIE;
  USART1->CR1 = to_send_.used() > 0 ? receiving | USART_CR1_TXEIE : receiving;
}

}  // namespace gs::stm32f405

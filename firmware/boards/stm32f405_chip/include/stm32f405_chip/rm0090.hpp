// The registers of the STM32F405 that the boards use, by their names in the reference manual
// RM0090.
#pragma once

#include <cortex_m4/core.hpp>

#include <cstdint>

namespace gs::stm32f405 {

using Register = volatile std::uint32_t;

struct Rcc {
  Register CR, PLLCFGR, CFGR, CIR, AHB1RSTR, AHB2RSTR, AHB3RSTR, reserved0, APB1RSTR, APB2RSTR,
      reserved1[2], AHB1ENR, AHB2ENR, AHB3ENR, reserved2, APB1ENR, APB2ENR, reserved3[2], AHB1LPENR,
      AHB2LPENR, AHB3LPENR, reserved4, APB1LPENR, APB2LPENR, reserved5[2], BDCR, CSR;
};
static_assert(sizeof(Rcc) == 0x78);
constexpr std::uint32_t RCC_CR_HSEON = 1u << 16, RCC_CR_HSERDY = 1u << 17;
constexpr std::uint32_t RCC_CR_PLLON = 1u << 24, RCC_CR_PLLRDY = 1u << 25;
constexpr std::uint32_t RCC_PLLCFGR_PLLSRC_HSE = 1u << 22;
constexpr std::uint32_t RCC_CFGR_SW_PLL = 2u, RCC_CFGR_SWS = 3u << 2, RCC_CFGR_SWS_PLL = 2u << 2;
constexpr std::uint32_t RCC_CFGR_PPRE1_DIV4 = 5u << 10, RCC_CFGR_PPRE2_DIV2 = 4u << 13;
constexpr std::uint32_t RCC_AHB1ENR_GPIOAEN = 1u << 0, RCC_AHB1ENR_GPIOCEN = 1u << 2;
constexpr std::uint32_t RCC_AHB1ENR_DMA1EN = 1u << 21;
constexpr std::uint32_t RCC_AHB1ENR_DMA2EN = 1u << 22, RCC_AHB2ENR_RNGEN = 1u << 6;
constexpr std::uint32_t RCC_APB1ENR_TIM2EN = 1u << 0, RCC_APB1ENR_TIM3EN = 1u << 1;
constexpr std::uint32_t RCC_APB1ENR_DACEN = 1u << 29, RCC_APB2ENR_TIM8EN = 1u << 1;
constexpr std::uint32_t RCC_APB2ENR_USART1EN = 1u << 4, RCC_APB2ENR_ADC1EN = 1u << 8;
constexpr std::uint32_t RCC_CSR_IWDGRSTF = 1u << 29, RCC_CSR_RMVF = 1u << 24;

struct Flash {
  Register ACR, KEYR, OPTKEYR, SR, CR;
};
constexpr std::uint32_t FLASH_ACR_LATENCY_5WS = 5u, FLASH_ACR_PRFTEN = 1u << 8;
constexpr std::uint32_t FLASH_ACR_ICEN = 1u << 9;
constexpr std::uint32_t FLASH_SR_BSY = 1u << 16, FLASH_SR_ERRORS = 0xF2u;
constexpr std::uint32_t FLASH_CR_PG = 1u << 0, FLASH_CR_SER = 1u << 1, FLASH_CR_PSIZE_X32 = 2u << 8;
constexpr std::uint32_t FLASH_CR_STRT = 1u << 16, FLASH_CR_LOCK = 1u << 31;
constexpr unsigned FLASH_CR_SNB_Pos = 3;

struct Gpio {
  Register MODER, OTYPER, OSPEEDR, PUPDR, IDR, ODR, BSRR, LCKR, AFR[2];
};
constexpr std::uint32_t GPIO_MODER_OUTPUT = 1u, GPIO_MODER_ALTERNATE = 2u, GPIO_MODER_ANALOG = 3u;

struct Usart {
  Register SR, DR, BRR, CR1, CR2, CR3, GTPR;
};
constexpr std::uint32_t USART_SR_RXNE = 1u << 5, USART_SR_TXE = 1u << 7, USART_SR_ORE = 1u << 3;
constexpr std::uint32_t USART_CR1_RE = 1u << 2, USART_CR1_TE = 1u << 3, USART_CR1_RXNEIE = 1u << 5;
constexpr std::uint32_t USART_CR1_TXEIE = 1u << 7, USART_CR1_UE = 1u << 13;

struct Timer {
  Register CR1, CR2, SMCR, DIER, SR, EGR, CCMR1, CCMR2, CCER, CNT, PSC, ARR, RCR, CCR[4];
};
constexpr std::uint32_t TIM_CR1_CEN = 1u << 0, TIM_CR1_CKD_DIV4 = 2u << 8;
constexpr std::uint32_t TIM_CR2_MMS_ENABLE = 1u << 4, TIM_CR2_MMS_UPDATE = 2u << 4;
constexpr std::uint32_t TIM_SMCR_SMS_TRIGGER = 6u, TIM_SMCR_TS_ITR1 = 1u << 4;
constexpr std::uint32_t TIM_SMCR_SMS_EXTERNAL1 = 7u, TIM_SMCR_TS_ITR2 = 2u << 4;

// Of channel `channel`, 0 … 3: of the half of CCMR that it is in, of CCER, of DIER and SR.
constexpr std::uint32_t TIM_CCMR_CAPTURE = 1u, TIM_CCMR_FILTER_DIV32_8 = 15u << 4;
constexpr std::uint32_t TIM_CCER_BOTH_EDGES = 1u << 0 | 1u << 1 | 1u << 3;
constexpr std::uint32_t TIM_SR_CCIF(unsigned channel) {
  return 2u << channel;
}
constexpr std::uint32_t TIM_SR_CCOF(unsigned channel) {
  return 0x200u << channel;
}

struct Dac {
  Register CR, SWTRIGR, DHR12R1, DHR12L1, DHR8R1, DHR12R2, DHR12L2, DHR8R2, DHR12RD, DHR12LD,
      DHR8RD, DOR1, DOR2, SR;
};
static_assert(sizeof(Dac) == 0x38);
constexpr std::uint32_t DAC_CR_EN1 = 1u << 0, DAC_CR_TEN1 = 1u << 2, DAC_CR_TSEL1_TIM8 = 1u << 3;
constexpr std::uint32_t DAC_CR_DMAEN1 = 1u << 12, DAC_CR_DMAUDRIE1 = 1u << 13;
constexpr std::uint32_t DAC_SR_DMAUDR1 = 1u << 13;

struct Adc {
  Register SR, CR1, CR2, SMPR1, SMPR2, JOFR[4], HTR, LTR, SQR1, SQR2, SQR3, JSQR, JDR[4], DR;
};
constexpr std::uint32_t ADC_CR2_ADON = 1u << 0, ADC_CR2_DMA = 1u << 8, ADC_CR2_DDS = 1u << 9;
constexpr std::uint32_t ADC_CR2_EXTSEL_TIM3_TRGO = 8u << 24, ADC_CR2_EXTEN_RISING = 1u << 28;

// Common to the three ADCs.
struct AdcCommon {
  Register CSR, CCR, CDR;
};
constexpr std::uint32_t ADC_CCR_ADCPRE_DIV4 = 1u << 16;

struct DmaStream {
  Register CR, NDTR, PAR, M0AR, M1AR, FCR;
};
struct Dma {
  Register LISR, HISR, LIFCR, HIFCR;
  DmaStream S[8];
};
constexpr std::uint32_t DMA_SxCR_EN = 1u << 0, DMA_SxCR_HTIE = 1u << 3, DMA_SxCR_TCIE = 1u << 4;
constexpr std::uint32_t DMA_SxCR_CIRC = 1u << 8, DMA_SxCR_MINC = 1u << 10;
constexpr std::uint32_t DMA_SxCR_PSIZE_16 = 1u << 11, DMA_SxCR_MSIZE_16 = 1u << 13;
constexpr std::uint32_t DMA_SxCR_DIR_FROM_MEMORY = 1u << 6;
constexpr std::uint32_t DMA_SxCR_CHSEL_7 = 7u << 25;
constexpr std::uint32_t DMA_SxCR_PL_HIGH = 2u << 16;
constexpr std::uint32_t DMA_LIFCR_STREAM0 = 0x3Du, DMA_HIFCR_STREAM5 = 0x3Du << 6;

// Random number generator; it needs the 48 MHz of the PLL.
struct Rng {
  Register CR, SR, DR;
};
constexpr std::uint32_t RNG_CR_RNGEN = 1u << 2, RNG_SR_DRDY = 1u << 0;

struct Iwdg {
  Register KR, PR, RLR, SR;
};
constexpr std::uint32_t IWDG_KR_START = 0xCCCCu, IWDG_KR_UNLOCK = 0x5555u, IWDG_KR_FEED = 0xAAAAu;

constexpr cortex_m4::At<Timer, 0x40000000u> TIM2;
constexpr cortex_m4::At<Timer, 0x40000400u> TIM3;
constexpr cortex_m4::At<Iwdg, 0x40003000u> IWDG;
constexpr cortex_m4::At<Dac, 0x40007400u> DAC;
constexpr cortex_m4::At<Timer, 0x40010400u> TIM8;
constexpr cortex_m4::At<Usart, 0x40011000u> USART1;
constexpr cortex_m4::At<Adc, 0x40012000u> ADC1;
constexpr cortex_m4::At<AdcCommon, 0x40012300u> ADC;
constexpr cortex_m4::At<Gpio, 0x40020000u> GPIOA;
constexpr cortex_m4::At<Gpio, 0x40020800u> GPIOC;
constexpr cortex_m4::At<Rcc, 0x40023800u> RCC;
constexpr cortex_m4::At<Flash, 0x40023C00u> FLASH;
constexpr cortex_m4::At<Dma, 0x40026000u> DMA1;
constexpr cortex_m4::At<Dma, 0x40026400u> DMA2;
constexpr cortex_m4::At<Rng, 0x50060800u> RNG;
// Device id: 0x413 for the STM32F405/407 and 415/417.
constexpr cortex_m4::At<Register, 0xE0042000u> DBGMCU_IDCODE;
constexpr std::uint32_t DBGMCU_IDCODE_DEV_ID = 0xFFFu, kF405 = 0x413u;

// The chip's unique id, 96 bits.
constexpr std::uintptr_t kUniqueId = 0x1FFF7A10u;

constexpr unsigned kDma1Stream5Irq = 16, kTim2Irq = 28, kTim6DacIrq = 54;
constexpr unsigned kUsart1Irq = 37, kDma2Stream0Irq = 56, kInterrupts = 57;

}  // namespace gs::stm32f405

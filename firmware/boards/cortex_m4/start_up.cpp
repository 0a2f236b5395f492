// Start-up code, from reset to main().
#include <cortex_m4/core.hpp>
#include <cortex_m4/vectors.hpp>

#include <cstdint>

using gs::cortex_m4::gs_hang;

extern "C" {

extern std::uint32_t gs_stack_bottom[];
extern std::uint32_t gs_data_load[];
extern std::uint32_t gs_data_start[];
extern std::uint32_t gs_data_end[];
extern std::uint32_t gs_bss_start[];
extern std::uint32_t gs_bss_end[];

int main();

[[noreturn]] void gs_start() {
  // Volatile, so that the compiler does not call memcpy before memory is set up.
  const volatile std::uint32_t* from = gs_data_load;
  for (volatile std::uint32_t* to = gs_data_start; to != gs_data_end; ++to, ++from) {
    *to = *from;
  }
  for (volatile std::uint32_t* to = gs_bss_start; to != gs_bss_end; ++to) {
    *to = 0;
  }
  // FPDSCR: interrupt handlers, too, start with IEEE 754 defaults: round to nearest, subnormal
  // numbers and NaN payloads preserved.
  gs::cortex_m4::word_at(0xE000EF3Cu) = 0;
  main();
  gs_hang();
  __builtin_unreachable();
}

// Enables the floating-point unit before any compiled code, because a compiler may use its
// registers anywhere. Fills the stack with a pattern, so that its use can be measured.
__attribute__((naked)) void gs_reset() {
  asm volatile(
      "ldr r0, =0xE000ED88\n\t"  // CPACR: full access to coprocessors 10 and 11
      "ldr r1, [r0]\n\t"
      "orr r1, r1, #0xF00000\n\t"
      "str r1, [r0]\n\t"
      "dsb\n\t"
      "isb\n\t"
      "movs r1, #0\n\t"
      "vmsr fpscr, r1\n\t"
      "ldr r0, =gs_stack_bottom\n\t"
      "ldr r1, =gs_stack_top\n\t"
      "ldr r2, =0xA5A5A5A5\n\t"
      "1: str r2, [r0], #4\n\t"
      "cmp r0, r1\n\t"
      "bne 1b\n\t"
      "b gs_start\n\t"
      ".ltorg");
}

// Called if a pure virtual function is called during construction: a defect.
void __cxa_pure_virtual() {
  gs_hang();
}

__attribute__((naked)) void gs_hang() {
  asm volatile("b .");
}

}  // extern "C"

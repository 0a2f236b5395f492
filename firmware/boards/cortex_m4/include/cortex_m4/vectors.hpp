// Vector table and default handlers. Each board defines its own table in the section .vectors, and
// a main() that never returns.
#pragma once

#include <cstddef>

namespace gs::cortex_m4 {

using Handler = void (*)();

extern "C" {
// Initial stack pointer, from the linker script.
extern char gs_stack_top[];
void gs_reset();
// Handler of faults and unexpected interrupts: loops until the watchdog restarts the outlet, which
// then reports the restart.
void gs_hang();
}

template <std::size_t kInterrupts>
struct VectorTable {
  const void* stack_top = gs_stack_top;
  Handler reset = gs_reset;
  Handler nmi = gs_hang;
  Handler faults[4] = {gs_hang, gs_hang, gs_hang, gs_hang};
  Handler reserved[4] = {};
  Handler svcall = gs_hang;
  Handler debug = gs_hang;
  Handler reserved_too = nullptr;
  Handler pendsv = gs_hang;
  Handler systick = gs_hang;
  Handler interrupts[kInterrupts] = {};
};
static_assert(sizeof(VectorTable<1>) == 17 * sizeof(void*), "layout required by the processor");

}  // namespace gs::cortex_m4

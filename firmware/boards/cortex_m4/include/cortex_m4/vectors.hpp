// The vector table and what stands behind it. Each board lays out its own, in the section .vectors,
// and has a main() that never returns.
#pragma once

#include <cstddef>

namespace gs::cortex_m4 {

using Handler = void (*)();

extern "C" {
// Of the linker script: the stack's end, where it begins to be used.
extern char gs_stack_top[];
void gs_reset();
// Faults and interrupts that nobody asked for. The watchdog ends it, and the restart is told.
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
static_assert(sizeof(VectorTable<1>) == 17 * sizeof(void*), "as the processor reads it");

}  // namespace gs::cortex_m4

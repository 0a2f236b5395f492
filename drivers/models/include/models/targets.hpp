// Runtime dispatch between two versions of the same code: one built for AVX2, one for any machine.
// Everything is inlined into both versions, so that neither calls code of the other.
#pragma once

namespace gsbench::models {

template <class Body>
[[gnu::flatten]] void run_on_any(const Body& body) {
  body();
}

#if defined(__x86_64__)
template <class Body>
[[gnu::flatten, gnu::target("avx2")]] void run_on_avx2(const Body& body) {
  body();
}
#endif

inline bool has_avx2() {
#if defined(__x86_64__)
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
#else
  return false;
#endif
}

template <class Body>
void run_on_this_machine(const Body& body) {
#if defined(__x86_64__)
  if (has_avx2()) {
    run_on_avx2(body);
    return;
  }
#endif
  run_on_any(body);
}

}  // namespace gsbench::models

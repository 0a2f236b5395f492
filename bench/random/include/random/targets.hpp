// Code twice, for AVX2 and for any machine. Everything is inlined into the two, so that no code for
// the one is ever called by the other.
#pragma once

#define GSBENCH_FOR_ANY [[gnu::flatten]]
#if defined(__x86_64__)
#define GSBENCH_FOR_AVX2 [[gnu::flatten, gnu::target("avx2")]]
#else
#define GSBENCH_FOR_AVX2 [[gnu::flatten]]
#endif

namespace gsbench::random {

template <class Function>
Function* of_this_machine(Function* any, Function* avx2) {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  return has_avx2 ? avx2 : any;
#else
  return avx2 != nullptr ? avx2 : any;
#endif
}

}  // namespace gsbench::random

// Entry point of libFuzzer for the wire fuzzer named by GSBENCH_FUZZER.
#include "wire_input.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

const gsbench::fuzz::WireFuzzer& this_fuzzer() {
  for (const gsbench::fuzz::WireFuzzer& fuzzer : gsbench::fuzz::wire_fuzzers()) {
    if (std::strcmp(fuzzer.name, GSBENCH_FUZZER) == 0) {
      return fuzzer;
    }
  }
  std::fprintf(stderr, "unknown fuzzer %s\n", GSBENCH_FUZZER);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gsbench::fuzz::WireFuzzer& fuzzer = this_fuzzer();
  const std::string wrong = fuzzer.wrong_with(data, size);
  if (!wrong.empty()) {
    std::fprintf(stderr, "%s\n", wrong.c_str());
    std::abort();
  }
  return 0;
}

// write_fuzz_seeds FOLDER: writes the seeds of the wire fuzzers to FOLDER/<fuzzer>/<number>.
#include "wire_input.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_fuzz_seeds FOLDER\n");
    return 2;
  }
  for (const gsbench::fuzz::WireFuzzer& fuzzer : gsbench::fuzz::wire_fuzzers()) {
    const std::filesystem::path folder = std::filesystem::path(argv[1]) / fuzzer.name;
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const std::string& seed : fuzzer.seeds()) {
      std::ofstream file(folder / std::to_string(number++), std::ios::binary);
      file << seed;
      if (!file.flush()) {
        std::fprintf(stderr, "cannot write to %s\n", folder.c_str());
        return 1;
      }
    }
  }
  return 0;
}

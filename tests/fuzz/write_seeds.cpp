// write_fuzz_seeds FOLDER: writes the seeds of the wire and generator fuzzers to
// FOLDER/<fuzzer>/<number>.
#include "generator_input.hpp"
#include "wire_input.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace {

bool write(const std::filesystem::path& folder, const std::vector<std::string>& seeds) {
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : seeds) {
    std::ofstream file(folder / std::to_string(number++), std::ios::binary);
    file << seed;
    if (!file.flush()) {
      std::fprintf(stderr, "cannot write to %s\n", folder.c_str());
      return false;
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: write_fuzz_seeds FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  bool written = write(folder / "generator", gsbench::fuzz::generator_seeds());
  for (const gsbench::fuzz::WireFuzzer& fuzzer : gsbench::fuzz::wire_fuzzers()) {
    written = written && write(folder / fuzzer.name, fuzzer.seeds());
  }
  return written ? 0 : 1;
}

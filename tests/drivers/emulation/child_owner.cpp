// Starts a child that sleeps, writes the child's process id to a file, and waits to be killed.
#include <unistd.h>

#include <cstdio>

#include <emulation/child.hpp>

int main(int, char** argv) {
  const auto child = gsbench::emulation::Child::start({{"sleep", "1000"}, ""});
  if (!child.ok()) {
    return 1;
  }
  // Renamed when complete, so that the test never reads half a number.
  const std::string path = argv[1];
  std::FILE* const file = std::fopen((path + ".new").c_str(), "w");
  if (file == nullptr) {
    return 1;
  }
  std::fprintf(file, "%d\n", static_cast<int>(child.value().pid()));
  std::fclose(file);
  std::rename((path + ".new").c_str(), path.c_str());
  pause();
  return 0;
}

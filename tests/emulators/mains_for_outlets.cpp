// mains_for_outlets FOLDER ID…: plays nominal voltage at 50 Hz in real time to outlets that others
// start. It prints the terminals file and the doorbell of each, one line for each outlet, and ends
// when its standard input is closed.
#include <poll.h>
#include <test_support/demand.hpp>
#include <test_support/mains.hpp>
#include <unistd.h>

#include <cstdio>
#include <exception>

#include <emulation/mains.hpp>

namespace {

bool input_is_open() {
  pollfd input = {STDIN_FILENO, POLLIN, 0};
  char byte = 0;
  return ::poll(&input, 1, 0) == 0 || ::read(STDIN_FILENO, &byte, 1) > 0;
}

}  // namespace

int main(int argc, char** argv) try {
  gsbench::emulation::MainsOptions options;
  options.folder = argv[1];
  for (int i = 2; i < argc; ++i) {
    options.outlets.push_back({argv[i]});
  }
  const auto mains = gsbench::test::demand(gsbench::emulation::Mains::create(options));
  for (std::size_t i = 0; i < options.outlets.size(); ++i) {
    std::printf("%s %s\n", mains->terminal_path(i).c_str(), mains->doorbell_path(i).c_str());
  }
  std::fflush(stdout);
  gsbench::test::Mains voltage;
  voltage.duration_s = 3600.0;
  gsbench::test::start(mains->source(), voltage);
  for (std::int64_t tick = 128; input_is_open() && tick < voltage.total_ticks(); tick += 128) {
    gsbench::test::advance(mains->source(), tick);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "mains_for_outlets: %s\n", error.what());
  return 1;
}

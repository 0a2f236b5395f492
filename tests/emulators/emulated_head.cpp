// emulated_head: a DAC head, the source of a station, as a process. It prints its port, and then
// for each 2 ms of its output, in real time, the mean square of the voltage at the DAC's pin in V².
// It ends when its standard output is closed.
#include <test_support/demand.hpp>

#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <numeric>
#include <thread>

#include <emulation/head_emulator.hpp>

int main() try {
  using gsbench::emulation::TrueTime;
  constexpr std::int64_t kBlock_steps = TrueTime::kRate_hz / 500;
  std::signal(SIGPIPE, SIG_IGN);
  const auto head = gsbench::test::demand(gsbench::emulation::HeadEmulator::create({}));
  std::printf("%s\n", head->port().c_str());
  const TrueTime time;
  std::array<float, kBlock_steps> volts = {};
  for (std::int64_t step = 0; std::fflush(stdout) == 0; step += kBlock_steps) {
    while (time.now() < step + kBlock_steps) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    head->render(step, volts.size(), volts.data());
    const float sum = std::inner_product(volts.begin(), volts.end(), volts.begin(), 0.0F);
    std::printf("%.6f\n", static_cast<double>(sum / kBlock_steps));
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "emulated_head: %s\n", error.what());
  return 1;
}

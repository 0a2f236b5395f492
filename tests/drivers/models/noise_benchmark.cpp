// Cost of one Gaussian value, in blocks of 16 ms at 8 kHz as a run asks for them.
#include <array>

#include <benchmark/benchmark.h>

#include <models/noise.hpp>

namespace {

void AddGaussian(benchmark::State& state) {
  std::array<float, 128> samples{};
  std::uint64_t first = 0;
  for (auto _ : state) {
    gsbench::models::add_gaussian({1, gsbench::models::kTest, 0}, first, samples.size(), 0.01f,
                                  samples.data());
    benchmark::DoNotOptimize(samples);
    first += samples.size();
  }
  state.counters["time_per_value"] = benchmark::Counter(
      static_cast<double>(first), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(AddGaussian);

void Uniform(benchmark::State& state) {
  std::uint64_t n = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(gsbench::models::uniform({1, gsbench::models::kTest, 0}, n++));
  }
}
BENCHMARK(Uniform);

}  // namespace

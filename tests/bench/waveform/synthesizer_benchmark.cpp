// Time per sample at 8 kHz, in blocks of 16 ms as in a run.
#include "example_references.hpp"

#include <array>

#include <benchmark/benchmark.h>

namespace gsbench::waveform {
namespace {

void play(benchmark::State& state, const Synthesizer& synthesizer) {
  std::array<float, 128> samples{};
  std::int64_t tick = 0;
  std::int64_t rendered = 0;
  for (auto _ : state) {
    synthesizer.render(tick, samples.size(), samples.data());
    benchmark::DoNotOptimize(samples);
    tick = (tick + 128) % 480'000;  // repeats after a minute
    rendered += 128;
  }
  state.counters["time_per_sample"] = benchmark::Counter(
      static_cast<double>(rendered), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void Constant(benchmark::State& state) {
  play(state, {constant(50.0, 50.0), {}, 8000});
}
BENCHMARK(Constant);

void LossOf500Mw(benchmark::State& state) {
  play(state, {loss_of_500_mw(3.0), {}, 8000});
}
BENCHMARK(LossOf500Mw);

void RecordingEvery2Seconds(benchmark::State& state) {
  std::vector<recording::TracePoint> points;
  points.reserve(3600);
  for (int i = 0; i < 3600; ++i) {
    points.push_back({2.0 * i, 50.0 + 0.02 * (i % 5), 1.0});
  }
  play(state, {reference_from_points(50.0, points), {}, 8000});
}
BENCHMARK(RecordingEvery2Seconds);

void LossWithHarmonicsOfEn50160(benchmark::State& state) {
  SignalSpec spec;
  spec.harmonics = en50160_harmonics();
  play(state, {loss_of_500_mw(3.0), spec, 8000});
}
BENCHMARK(LossWithHarmonicsOfEn50160);

}  // namespace
}  // namespace gsbench::waveform

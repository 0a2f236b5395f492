#include "check_signal.hpp"
#include "excess_phase.hpp"
#include "flickers.hpp"
#include "partials.hpp"
#include "schedule.hpp"
#include "sine.hpp"
#include "tones.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <waveform/synthesizer.hpp>

namespace gsbench::waveform {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::shared_ptr<const ReferenceSignal> checked(std::shared_ptr<const ReferenceSignal> reference,
                                               const SignalSpec& spec,
                                               std::int64_t sample_rate_hz) {
  if (reference == nullptr) {
    throw std::invalid_argument("the signal has no reference");
  }
  check_signal(spec, reference->nominal_hz(), sample_rate_hz);
  return reference;
}

std::vector<Phasor> harmonic_series(const std::vector<Harmonic>& harmonics) {
  std::vector<Phasor> series = {{0.0, 0.0}, {1.0, 0.0}};
  for (const Harmonic& harmonic : harmonics) {
    if (!is_of_series(harmonic)) {
      continue;
    }
    const auto order = static_cast<std::size_t>(harmonic.order);
    if (series.size() <= order) {
      series.resize(order + 1);
    }
    const double amplitude = harmonic.amplitude_pct / 100.0;
    const double phase_rad = harmonic.phase_deg / 180.0 * kPi;
    series[order] = {amplitude * std::cos(phase_rad), amplitude * std::sin(phase_rad)};
  }
  return series;
}

}  // namespace

struct Synthesizer::Impl {
  Impl(std::shared_ptr<const ReferenceSignal> the_reference, const SignalSpec& spec,
       std::int64_t rate_hz)
      : reference(checked(std::move(the_reference), spec, rate_hz)),
        sample_rate_hz(rate_hz),
        block_ticks(rate_hz / 1000 * 16),
        nominal_phase(reference->nominal_hz(), rate_hz),
        excess_phase(*reference, rate_hz),
        schedule(spec, rate_hz),
        series(harmonic_series(spec.harmonics)),
        partials(spec.harmonics, reference->nominal_hz(), rate_hz),
        flickers(spec.flickers, rate_hz),
        tones(spec.tones, rate_hz),
        offset(spec.dc_offset_pct / 100.0) {}

  // Common values of all samples of a block. Blocks have fixed boundaries, so that a sample is
  // computed from the same numbers for any requested range.
  struct Block {
    std::int64_t first_tick;
    std::int64_t end_tick;
    double nominal_cycles;  // at first_tick
  };

  void render_block(const Block& block, std::int64_t from, std::int64_t end, float* out) const;
  void render_piece(const Block& block, const SmoothPiece& piece, std::int64_t from,
                    std::int64_t end, float* out) const;

  std::shared_ptr<const ReferenceSignal> reference;
  std::int64_t sample_rate_hz;
  std::int64_t block_ticks;
  NominalPhase nominal_phase;
  ExcessPhase excess_phase;
  Schedule schedule;
  std::vector<Phasor> series;
  Partials partials;
  Flickers flickers;
  Tones tones;
  double offset;
};

void Synthesizer::Impl::render_piece(const Block& block, const SmoothPiece& piece,
                                     std::int64_t from, std::int64_t end, float* out) const {
  for (std::size_t entry = schedule.index_at(from); from < end; ++entry) {
    const ScheduleEntry& signal = schedule[entry];
    const Stretch stretch = {
        block.nominal_cycles + piece.cycles_at_start + signal.offset_cycles,
        reference->nominal_hz() / static_cast<double>(sample_rate_hz),
        piece.start - static_cast<double>(block.first_tick),
        1.0 / piece.length,
        piece.cycles,
        signal.level * piece.voltage_pu,
        signal.level * piece.voltage_slope_pu,
        offset,
    };
    const std::int64_t stretch_end = std::min(end, schedule.end_tick(entry));
    const auto first = static_cast<int>(from - block.first_tick);
    const auto count = static_cast<int>(stretch_end - from);
    if (series.size() > 2) {
      render_harmonics(stretch, series, first, count, out);
    } else {
      render_sine(stretch, first, count, out);
    }
    partials.add(block.first_tick, piece, signal, stretch, first, count, out);
    out += count;
    from = stretch_end;
  }
}

void Synthesizer::Impl::render_block(const Block& block, std::int64_t from, std::int64_t end,
                                     float* out) const {
  ExcessPhase::Edge edge = excess_phase.edge_at(block.first_tick);
  while (from < end) {
    const ExcessPhase::Edge next = excess_phase.next_edge(edge, block.end_tick);
    // A sample at a corner belongs to the piece that begins there.
    const std::int64_t piece_end =
        std::min(end, static_cast<std::int64_t>(std::ceil(next.position)));
    if (from < piece_end) {
      render_piece(block, excess_phase.piece(edge, next), from, piece_end, out);
      out += piece_end - from;
      from = piece_end;
    }
    edge = next;
  }
}

Synthesizer::Synthesizer(std::shared_ptr<const ReferenceSignal> reference, const SignalSpec& spec,
                         std::int64_t sample_rate_hz)
    : impl_(std::make_shared<const Impl>(std::move(reference), spec, sample_rate_hz)) {}

void Synthesizer::render(std::int64_t first_tick, std::size_t count, float* out) const {
  if (first_tick < 0) {
    throw std::invalid_argument(fmt::format("first_tick is {}; it must be at least 0", first_tick));
  }
  const std::int64_t end_tick = first_tick + static_cast<std::int64_t>(count);
  for (std::int64_t tick = first_tick; tick < end_tick;) {
    const std::int64_t block_tick = tick - tick % impl_->block_ticks;
    const Impl::Block block = {block_tick, block_tick + impl_->block_ticks,
                               impl_->nominal_phase.cycles_at(block_tick)};
    const std::int64_t end = std::min(end_tick, block.end_tick);
    impl_->render_block(block, tick, end, out);
    if (impl_->flickers.is_on(tick, end)) {
      impl_->flickers.modulate(tick, end, static_cast<float>(impl_->offset), out);
    }
    impl_->tones.add(block.first_tick, tick, end, out);
    out += end - tick;
    tick = end;
  }
}

double Synthesizer::amplitude_pu(std::int64_t tick) const {
  const double t_s = static_cast<double>(tick) / static_cast<double>(impl_->sample_rate_hz);
  return impl_->schedule[impl_->schedule.index_at(tick)].level * impl_->reference->voltage_pu(t_s) *
         impl_->flickers.factor(tick);
}

std::int64_t Synthesizer::sample_rate_hz() const {
  return impl_->sample_rate_hz;
}

const ReferenceSignal& Synthesizer::reference() const {
  return *impl_->reference;
}

}  // namespace gsbench::waveform

// The firmware, its output and its inputs. The line: head_emulator_line.cpp.
#include <sys/eventfd.h>

#include <algorithm>
#include <cmath>

#include <app/application.hpp>
#include <emulation/head_emulator.hpp>
#include <head/interpolator.hpp>

namespace gsbench::emulation {

using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

// Of the board's capture timer, 84 MHz.
constexpr std::uint32_t kCountsPerSample = 10500;
constexpr double kCountsPerCode = static_cast<double>(kCountsPerSample) / gs::head::kOversampling;

}  // namespace

HeadEmulator::HeadEmulator(const HeadEmulatorOptions& options, LoopbackPort port, Descriptor wake)
    : options_(options), port_(std::move(port)), wake_(std::move(wake)) {
  start_firmware();
}

Result<std::unique_ptr<HeadEmulator>> HeadEmulator::create(const HeadEmulatorOptions& options) {
  Result<LoopbackPort> port = LoopbackPort::reserve();
  if (!port.ok()) {
    return Error{port.error()};
  }
  std::unique_ptr<HeadEmulator> head(
      new HeadEmulator(options, port.take(), Descriptor(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK))));
  if (const Status listening = head->plug_in(); !listening.ok()) {
    return Error{listening.error()};
  }
  head->thread_ = std::thread([&served = *head] { served.serve(); });
  return head;
}

HeadEmulator::~HeadEmulator() {
  {
    const Lock lock(mutex_);
    ending_ = true;
  }
  ring();
  if (thread_.joinable()) {
    thread_.join();
  }
}

void HeadEmulator::start_firmware() {
  gs::head::Hardware hardware;
  gs::app::set_text(hardware.board, options_.board.c_str());
  hardware.flags = options_.flags;
  hardware.counts_per_sample = kCountsPerSample;
  hardware.full_scale_mv = static_cast<std::uint16_t>(std::lround(1e3 * options_.full_scale_v));
  head_.emplace(hardware);
  reader_ = {};
  codes_.fill(gs::head::kMidScale);
  for (std::size_t channel = 0; channel < closed_.size(); ++channel) {
    head_->edge(channel, closed_[channel], 0);
  }
}

void HeadEmulator::restart() {
  const Lock lock(mutex_);
  start_firmware();
  send_messages();
}

// ---- the output

double HeadEmulator::code_at(std::int64_t step) const {
  return static_cast<double>(step) * (1.0 + 1e-6 * options_.clock_ppm);
}

double HeadEmulator::count_at(std::int64_t step) const {
  return code_at(step) * kCountsPerCode;
}

// The DMA plays one block while the firmware computes the next one.
std::uint16_t HeadEmulator::code(std::int64_t number) {
  constexpr auto kCodes = static_cast<std::int64_t>(kBlock);
  for (; blocks_ <= number / kCodes + 1; ++blocks_) {
    const double first_count = static_cast<double>(blocks_ * kCodes) * kCountsPerCode;
    const bool was_armed = head_->state() == gs::head::State::kArmed;
    head_->next_codes(static_cast<std::uint64_t>(first_count),
                      &codes_[static_cast<std::size_t>(blocks_ % 2) * kBlock], kBlock);
    if (was_armed && head_->state() == gs::head::State::kPlaying) {
      observation_.stream_begin = blocks_ * kCodes;
    }
  }
  return codes_[static_cast<std::size_t>(number) % codes_.size()];
}

void HeadEmulator::render(std::int64_t first_step, std::size_t count, float* volts) {
  const Lock lock(mutex_);
  const double step_v = options_.full_scale_v * 16.0 / gs::head::kFullScale;
  double from = code_at(first_step);
  for (std::size_t i = 0; i < count; ++i) {
    const double until = code_at(first_step + static_cast<std::int64_t>(i) + 1);
    double sum = 0.0;
    for (double at = from; at < until;) {
      const double end = std::min(std::floor(at) + 1.0, until);
      const int deviation = output(static_cast<std::int64_t>(at)) - gs::head::kMidScale;
      sum += (end - at) * deviation;
      at = end;
    }
    volts[i] = static_cast<float>(sum / (until - from) * step_v);
    from = until;
  }
  end_step_ = first_step + static_cast<std::int64_t>(count);
  pass_edges();
  send_messages();
}

int HeadEmulator::output(std::int64_t number) {
  const std::uint16_t now = code(number);
  if (number > observation_.code) {
    observation_.code = number;
    if (now != gs::head::kMidScale) {
      observation_.last_driven = number;
    }
    if (recording_) {
      recorded_.push_back(now);
    }
  }
  return now;
}

// ---- the inputs

void HeadEmulator::set_input(std::size_t channel, std::int64_t step, bool closed) {
  const Lock lock(mutex_);
  edges_.push_back({step, channel, closed});
  pass_edges();
  send_messages();
}

void HeadEmulator::pass_edges() {
  for (auto edge = edges_.begin(); edge != edges_.end();) {
    if (edge->step > end_step_) {
      ++edge;
      continue;
    }
    if (closed_.at(edge->channel) != edge->closed) {
      closed_[edge->channel] = edge->closed;
      const double count = std::max(count_at(edge->step), 0.0);
      head_->edge(edge->channel, edge->closed, static_cast<std::uint64_t>(std::llround(count)));
    }
    edge = edges_.erase(edge);
  }
}

// ---- for tests

HeadEmulator::Observation HeadEmulator::observe() const {
  const Lock lock(mutex_);
  Observation observation = observation_;
  observation.state = head_->state();
  observation.buffered = head_->buffered();
  return observation;
}

void HeadEmulator::record_codes() {
  const Lock lock(mutex_);
  recording_ = true;
  recorded_.assign(static_cast<std::size_t>(observation_.code + 1), gs::head::kMidScale);
}

std::vector<std::uint16_t> HeadEmulator::recorded_codes() const {
  const Lock lock(mutex_);
  return recorded_;
}

}  // namespace gsbench::emulation

#include "generator_server.hpp"

#include <cmath>

#include <emulation/generator.hpp>

namespace gsbench::emulation {

using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

std::unique_ptr<GeneratorDialect> dialect_of(GeneratorModel model, GeneratorState& state) {
  switch (model) {
    case GeneratorModel::kSdg1032x:
    case GeneratorModel::kSdg2042x:
      return make_siglent(state, model == GeneratorModel::kSdg2042x);
    case GeneratorModel::kDg1062z:
      return make_rigol(state);
    case GeneratorModel::k33522b:
      break;
  }
  return make_keysight(state);
}

}  // namespace

class GeneratorCore {
 public:
  GeneratorCore(const GeneratorOptions& options, LoopbackPort port)
      : state(options),
        dialect(dialect_of(options.model, state)),
        server(std::move(port), state, *dialect, mutex) {}

  std::mutex plug;   // of starting and stopping the server; before `mutex`
  std::mutex mutex;  // of state, dialect and the server's log
  GeneratorState state;
  std::unique_ptr<GeneratorDialect> dialect;
  GeneratorServer server;
};

Generator::Generator(std::unique_ptr<GeneratorCore> core) : core_(std::move(core)) {}
Generator::~Generator() = default;

Result<std::unique_ptr<Generator>> Generator::start(const GeneratorOptions& options) {
  auto port = LoopbackPort::reserve();
  if (!port.ok()) {
    return Error{port.error()};
  }
  auto core = std::make_unique<GeneratorCore>(options, port.take());
  if (const Status started = core->server.start(); !started.ok()) {
    return Error{started.error()};
  }
  return std::unique_ptr<Generator>(new Generator(std::move(core)));
}

std::string Generator::port() const {
  return "tcp://127.0.0.1:" + std::to_string(core_->server.port_number());
}

void Generator::render(std::int64_t first_step, std::size_t count, float* volts) {
  core_->state.player().render(first_step, count, volts);
}

bool Generator::output_is_on() const {
  return settings().output_on;
}

GeneratorSettings Generator::settings() const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  return core_->state.settings();
}

std::optional<std::vector<std::int16_t>> Generator::waveform(const std::string& name) const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  const GeneratorWaveform* const found = core_->state.find(name);
  if (found == nullptr) {
    return std::nullopt;
  }
  std::vector<std::int16_t> codes(found->points());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    codes[i] =
        static_cast<std::int16_t>(std::lround(std::max(-32768.0, found->value(i) * 32767.0)));
  }
  return codes;
}

bool Generator::is_playing() const {
  return core_->state.player().is_playing();
}

std::vector<std::string> Generator::messages() const {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  return core_->server.log();
}

void Generator::clear_messages() {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  core_->server.log().clear();
}

void Generator::set_faults(const GeneratorFaults& faults) {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  core_->state.set_faults(faults);
  core_->server.faults_changed();
}

void Generator::at_message(int message, std::function<void()> then) {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  core_->server.at_message(message, std::move(then));
}

void Generator::press(const PanelChange& change) {
  const std::lock_guard<std::mutex> lock(core_->mutex);
  GeneratorState& state = core_->state;
  if (change.load_ohm) {
    state.set_load(*change.load_ohm);
  }
  GeneratorSettings next = state.settings();
  next.output_on = change.output_on.value_or(next.output_on);
  next.function = change.function.value_or(next.function);
  next.frequency_hz = change.frequency_hz.value_or(next.frequency_hz);
  next.amplitude_vpp = change.amplitude_vpp.value_or(next.amplitude_vpp);
  next.offset_v = change.offset_v.value_or(next.offset_v);
  next.sample_rate_hz = change.sample_rate_hz.value_or(next.sample_rate_hz);
  next.burst_on = change.burst_on.value_or(next.burst_on);
  state.set(next);
}

void Generator::reset_now(std::chrono::milliseconds starting_up) {
  const std::lock_guard<std::mutex> plug(core_->plug);
  core_->server.stop();
  {
    const std::lock_guard<std::mutex> lock(core_->mutex);
    core_->state.lose_power();
    core_->dialect->lose_power();
  }
  // With a delay, the port is opened by the server's thread, which reports no error.
  static_cast<void>(core_->server.start(std::max(starting_up, std::chrono::milliseconds(1))));
}

void Generator::unplug() {
  const std::lock_guard<std::mutex> plug(core_->plug);
  core_->server.stop();
}

Status Generator::plug_in() {
  const std::lock_guard<std::mutex> plug(core_->plug);
  return core_->server.start();
}

}  // namespace gsbench::emulation

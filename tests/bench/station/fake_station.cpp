#include "fake_station.hpp"

#include <link/version_text.hpp>

namespace gsbench::station::test {

using drivers::Done;
using drivers::Error;
using drivers::Status;

namespace {

constexpr std::int64_t kReportTicks = 128;

}  // namespace

source::Limits FakeStation::limits() const {
  source::Limits limits;
  limits.name = "fake source";
  limits.full_scale_pu = 1.5;
  limits.sample_rates_hz = {8000};
  limits.nominal_hz = {50};
  limits.noise_per_outlet = script_.noise_per_outlet;
  return limits;
}

Status FakeStation::power_up() {
  touched_ = true;
  source_on_ = true;  // a source that failed to start may be live all the same
  if (!script_.start_error.empty()) return Error{script_.start_error};
  return Done{};
}

drivers::Result<std::int64_t> FakeStation::play_until(std::int64_t until_tick) {
  if (script_.play_throws_at == plays_) throw std::runtime_error("fake source: thrown");
  if (script_.play_fails_at == plays_) return Error{"fake source: tripped"};
  played_tick_ = until_tick;
  ++plays_;
  return until_tick;
}

Status FakeStation::switch_off() noexcept {
  source_on_ = false;
  ++made_safe_;
  if (!script_.make_safe_error.empty()) return Error{script_.make_safe_error};
  return Done{};
}

drivers::Result<std::vector<link::OutletPresence>> FakeStation::open() {
  touched_ = true;
  link_open_ = true;
  if (!script_.open_error.empty()) return Error{script_.open_error};
  std::vector<link::OutletPresence> present(script_.outlets);
  for (std::size_t i = 0; i < present.size(); ++i) {
    present[i].id = "serial-" + std::to_string(i + 1);
    present[i].hello.firmware_version = 1002003;
    present[i].where = "fake";
    present[i].hello.sample_rate_hz = 8000;
    present[i].hello.nominal_hz = 50;
    present[i].hello.tracker_delay_s = 0.028F;
    if (is_last(i)) present[i].hello.protocol_version = script_.protocol_version;
    present[i].fault = link::protocol_fault(present[i].hello);
  }
  sent_.resize(present.size());
  answered_.resize(present.size());
  return present;
}

Status FakeStation::send(std::size_t outlet, const gs::wire::Downlink& message) {
  touched_ = true;
  if (script_.send_fails_at == sends_++) return Error{"fake link: cannot send"};
  sent_.at(outlet).push_back(message);
  return Done{};
}

void FakeStation::answer_settings(std::size_t outlet, std::vector<link::Received>& messages) const {
  link::Received answer;
  answer.outlet = outlet;
  answer.message.sample = static_cast<std::uint64_t>(reported_tick_);
  answer.message.kind = gs::wire::UplinkKind::kSettingsAnswer;
  answer.message.settings_answer = {};
  if (is_last(outlet)) answer.message.settings_answer.error = script_.settings_error;
  messages.push_back(answer);
}

Status FakeStation::poll(std::vector<link::Received>& messages, std::vector<link::Fault>&) {
  if (script_.link_poll_fails_at == link_polls_++) return Error{"fake link: broken"};
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    if (!sent_[i].empty() && !answered_[i] && !(is_last(i) && !script_.answers_settings)) {
      answer_settings(i, messages);
      answered_[i] = true;
    }
    for (std::int64_t tick = reported_tick_ + kReportTicks; tick <= played_tick_;
         tick += kReportTicks) {
      if (is_last(i) && tick >= script_.silent_from_tick) break;
      link::Received report;
      report.outlet = i;
      report.message.kind = gs::wire::UplinkKind::kMeasurement;
      report.message.sample = static_cast<std::uint64_t>(tick);
      report.message.measurement = {50.0F, 0.0F, 1.0F, gs::outlet::Validity::kValid};
      messages.push_back(report);
    }
  }
  reported_tick_ = played_tick_ / kReportTicks * kReportTicks;
  return Done{};
}

void FakeStation::close() noexcept {
  link_open_ = false;
  ++closed_;
}

Status FakeStation::poll(std::vector<relay::Edge>&) {
  if (script_.relay_poll_fails_at == relay_polls_++) return Error{"fake relay sense: unplugged"};
  return Done{};
}

}  // namespace gsbench::station::test

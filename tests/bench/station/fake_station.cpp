#include "fake_station.hpp"

#include <algorithm>

#include <link/version_text.hpp>

namespace gsbench::station::test {

using drivers::Done;
using drivers::Error;
using drivers::Status;

namespace {

constexpr std::int64_t kReportTicks = 128;

std::string id_of(std::size_t outlet) {
  return "serial-" + std::to_string(outlet + 1);
}

}  // namespace

source::Limits FakeStation::limits() const {
  source::Limits limits;
  limits.name = "fake source";
  limits.full_scale_pu = 1.5;
  limits.sample_rates_hz = {8000};
  limits.nominal_hz = {50};
  limits.kind = script_.kind;
  limits.noise_per_outlet = script_.noise_per_outlet;
  return limits;
}

Status FakeStation::power_up() {
  touched_ = true;
  energised_ = true;
  open_when_energised_ = link_open_;
  source_on_ = true;  // a source that failed to start may still be live
  if (!script_.start_error.empty()) {
    return Error{script_.start_error};
  }
  return heed("power_up");
}

Status FakeStation::heed(const std::string& call) {
  if (script_.stops_in != call) {
    return Done{};
  }
  *script_.stop = true;
  return interrupt().is_set() ? Status(Error{"fake source: interrupted"}) : Done{};
}

Status FakeStation::keep_up() {
  if (script_.hold_fails_at == holds_++) {
    return Error{"fake source: someone switched it off"};
  }
  return heed("keep_up");
}

drivers::Result<std::int64_t> FakeStation::play_until(std::int64_t until_tick) {
  if (script_.play_throws_at == plays_) {
    throw std::runtime_error("fake source: thrown");
  }
  if (script_.play_fails_at == plays_) {
    return Error{"fake source: tripped"};
  }
  if (const Status heeded = heed("play_until"); !heeded.ok()) {
    return Error{heeded.error()};
  }
  // Reads the samples like a streaming driver and discards them.
  const auto voltage_pu = samples(played_tick_, until_tick - played_tick_);
  if (!voltage_pu.ok()) {
    return Error{voltage_pu.error()};
  }
  played_tick_ = until_tick;
  ++plays_;
  return until_tick;
}

Status FakeStation::switch_off() noexcept {
  source_on_ = false;
  ++made_safe_;
  if (!script_.make_safe_error.empty()) {
    return Error{script_.make_safe_error};
  }
  return Done{};
}

std::vector<Slot> FakeStation::slots() const {
  std::vector<Slot> slots;
  for (std::size_t i = 0; i < script_.outlets; ++i) {
    Slot& slot = slots.emplace_back();
    slot.place = "fake";
    slot.serial_number = id_of(i);
    if (is_linked(i)) {
      slot.link_id = id_of(i);
    }
    if (is_last(i) && !script_.requires_serial_number.empty()) {
      slot.serial_number = script_.requires_serial_number;
      slot.requires_serial_number = true;
    }
    if (i < script_.relay_channels) {
      slot.relay_channel = i;
    }
  }
  return slots;
}

Status FakeStation::open() {
  touched_ = true;
  link_open_ = true;
  if (!script_.open_error.empty()) {
    return Error{script_.open_error};
  }
  return Done{};
}

void FakeStation::join(std::vector<link::Change>& changes) const {
  for (std::size_t i = 0; i < script_.outlets; ++i) {
    if (!is_linked(i) || !is_reachable(i) || (is_last(i) && !script_.joins)) {
      continue;
    }
    link::OutletPresence outlet{id_of(i), "fake", {}};
    outlet.hello.firmware_version = 1002003;
    outlet.hello.sample_rate_hz = 8000;
    outlet.hello.nominal_hz = 50;
    outlet.hello.tracker_delay_s = 0.028F;
    if (is_last(i)) {
      outlet.hello.protocol_version = script_.protocol_version;
    }
    outlet.fault = link::protocol_fault(outlet.hello);
    changes.emplace_back(outlet);
  }
}

Status FakeStation::send(const std::string& id, const gs::wire::Downlink& message) {
  touched_ = true;
  if (script_.send_fails_at == sends_++) {
    return Error{"fake link: cannot send"};
  }
  for (std::size_t i = 0; i < script_.outlets; ++i) {
    if (id_of(i) == id) {
      sent_[i].push_back(message);
    }
  }
  return Done{};
}

void FakeStation::answer_settings(std::size_t outlet, std::size_t number,
                                  std::vector<link::Received>& messages) const {
  if (is_last(outlet) &&
      !(number == 0 ? script_.answers_settings : script_.answers_later_settings)) {
    return;
  }
  link::Received answer;
  answer.id = id_of(outlet);
  answer.message.sample = static_cast<std::uint64_t>(reported_tick_);
  answer.message.kind = gs::wire::UplinkKind::kSettingsAnswer;
  answer.message.settings_answer = {};
  if (is_last(outlet)) {
    answer.message.settings_answer.error =
        number == 0 ? script_.settings_error : script_.later_settings_error;
  }
  messages.push_back(answer);
}

Status FakeStation::poll(link::Happenings& happenings) {
  if (!joined_) {
    joined_ = true;
    join(happenings.changes);
    return Done{};
  }
  if (script_.link_poll_fails_at == link_polls_++) {
    return Error{"fake link: broken"};
  }
  for (std::size_t i = 0; i < sent_.size(); ++i) {
    if (!is_linked(i)) {
      continue;
    }
    const auto sent = static_cast<std::size_t>(
        std::count_if(sent_[i].begin(), sent_[i].end(), [](const gs::wire::Downlink& message) {
          return message.kind == gs::wire::DownlinkKind::kSettings;
        }));
    for (; answered_[i] < sent; ++answered_[i]) {
      answer_settings(i, answered_[i], happenings.messages);
    }
    for (std::int64_t tick = reported_tick_ + kReportTicks; tick <= played_tick_;
         tick += kReportTicks) {
      if (is_last(i) && tick >= script_.silent_from_tick) {
        break;
      }
      link::Received report;
      report.id = id_of(i);
      report.message.kind = gs::wire::UplinkKind::kMeasurement;
      report.message.sample = static_cast<std::uint64_t>(tick);
      report.message.measurement = {50.0F, 0.0F, 1.0F, gs::outlet::Validity::kValid};
      happenings.messages.push_back(report);
    }
  }
  reported_tick_ = played_tick_ / kReportTicks * kReportTicks;
  return Done{};
}

std::vector<link::Fault> FakeStation::unreachable() {
  std::vector<link::Fault> faults;
  for (std::size_t i = 0; i < script_.outlets; ++i) {
    if (is_linked(i) && !is_reachable(i)) {
      faults.push_back({id_of(i), "cannot be reached: fake port: refused"});
    }
  }
  return faults;
}

void FakeStation::close() noexcept {
  link_open_ = false;
  ++closed_;
}

Status FakeStation::Sense::open() {
  return script_.sense_open_error.empty() ? Status(Done{}) : Error{script_.sense_open_error};
}

relay::Alignment FakeStation::Sense::alignment() const {
  return {
      script_.sense_count_at_tick_0, 1.0,
      script_.sense_uncertainty_ticks + (polls_ > 0 ? script_.sense_uncertainty_grows_ticks : 0.0),
      script_.sense_uncertainty_between_ticks};
}

Status FakeStation::Sense::poll(std::vector<relay::Edge>& edges) {
  if (script_.relay_poll_fails_at == polls_) {
    return Error{"fake relay sense: unplugged"};
  }
  if (polls_++ == 0) {
    edges.insert(edges.end(), script_.edges.begin(), script_.edges.end());
  }
  return Done{};
}

}  // namespace gsbench::station::test

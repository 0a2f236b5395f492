#include "watch.hpp"

#include "faults.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <waveform/synthesizer.hpp>

namespace gsbench::station {
namespace {

// An outlet reports every 16 ms. This limit is longer than the delays of a source's buffer and of a
// link. Without it a dead outlet could pass, since it reports no false event either.
constexpr double kLongestSilence_s = 1.0;

// Names of the failed gs::wire::SelfTestPart, without the ADC, which may not have had input yet.
std::string failed_parts(std::uint32_t failed) {
  std::string names;
  for (const auto& [part, name] : {std::pair(gs::wire::kArithmetic, "arithmetic"),
                                   {gs::wire::kSettingsStorage, "settings storage"},
                                   {gs::wire::kClock, "crystal"}}) {
    if ((failed & part) != 0) {
      names += (names.empty() ? "" : ", ") + std::string(name);
    }
  }
  return names;
}

// Errors that invalidate the run of the outlet that reports them. Other errors, such as a message
// that it did not understand, show in its later behaviour.
bool invalidates_run(gs::wire::ErrorCode error) {
  return error == gs::wire::ErrorCode::kSamplesLost || error == gs::wire::ErrorCode::kWatchdog ||
         error == gs::wire::ErrorCode::kSettingsStorage || error == gs::wire::ErrorCode::kClock;
}

// The answer to the settings with this number, from 0. `when`: how messages distinguish them.
void check_answer(record::OutletRecord& outlet,
                  const std::vector<gs::outlet::SettingsError>& answers, std::size_t number,
                  const std::string& when) {
  if (number >= answers.size()) {
    note(outlet, "did not acknowledge its settings" + when);
  } else if (answers[number] != gs::outlet::SettingsError::kNone) {
    note(outlet, "refused its settings" + when + ": " + gs::outlet::to_string(answers[number]));
  }
}

}  // namespace

Watch::Watch(std::vector<record::OutletRecord>& outlets, std::int64_t sample_rate_hz)
    : longest_silence_ticks_(waveform::tick_at(kLongestSilence_s, sample_rate_hz)) {
  for (record::OutletRecord& outlet : outlets) {
    if (outlet.took_part && !outlet.link.empty()) {
      sessions_[outlet.id].outlet = &outlet;
    }
  }
}

void Watch::process(link::Happenings& happenings, std::int64_t now) {
  for (const link::Change& change : happenings.changes) {
    process(change);
  }
  const auto is_discarded = [&](const link::Received& received) {
    const auto found = sessions_.find(received.id);
    if (found == sessions_.end()) {
      return true;
    }
    const gs::wire::Uplink& message = received.message;
    Session& session = found->second;
    session.last_message_tick = now;
    if (message.kind == gs::wire::UplinkKind::kError && invalidates_run(message.error.code)) {
      note(*session.outlet,
           std::string("reported the error: ") + gs::wire::to_string(message.error.code));
    }
    // The samples and settings of another start are not those of the run.
    session.start_number = session.start_number.value_or(message.start_number);
    session.ended = session.ended || message.start_number != *session.start_number;
    return session.ended;
  };
  std::vector<link::Received>& messages = happenings.messages;
  messages.erase(std::remove_if(messages.begin(), messages.end(), is_discarded), messages.end());
  for (const link::Fault& fault : happenings.faults) {
    if (const auto found = sessions_.find(fault.id); found != sessions_.end()) {
      note(*found->second.outlet, fault.what);
    }
  }
}

void Watch::process(const link::Change& change) {
  const auto* const joined = std::get_if<link::OutletPresence>(&change);
  const auto* const left = std::get_if<link::Fault>(&change);
  const auto found = sessions_.find(joined != nullptr ? joined->id : left->id);
  if (found == sessions_.end()) {
    return;
  }
  if (left != nullptr) {
    note(*found->second.outlet, left->what);
  } else if (found->second.outlet->link != joined->where) {
    note(*found->second.outlet, link::same_id_fault(joined->where));
    found->second.ended = true;
  } else if (!joined->fault.empty()) {
    note(*found->second.outlet, joined->fault);
    found->second.ended = true;
  }
}

void Watch::check_answers(const capture::Capture& capture) {
  for (const auto& [id, session] : sessions_) {
    check_answer(*session.outlet, capture.settings_answers(id), 0, "");
    const std::string failed = failed_parts(capture.self_test_failed(id));
    if (!failed.empty()) {
      note(*session.outlet, "failed its self test: " + failed);
    }
  }
}

void Watch::expect_answer(const std::string& id, double at_s, std::int64_t due) {
  sessions_.at(id).later_answers.push_back({at_s, due});
}

void Watch::check_later_answers(const capture::Capture& capture, std::int64_t now) {
  for (auto& [id, session] : sessions_) {
    std::size_t& next = session.later_answers_checked;
    for (; next < session.later_answers.size() && session.later_answers[next].due <= now; ++next) {
      check_answer(*session.outlet, capture.settings_answers(id), next + 1,
                   fmt::format(" of {:.6g} s", session.later_answers[next].at_s));
    }
  }
}

void Watch::check_silence(const capture::Capture& capture, std::int64_t now) {
  for (const auto& [id, session] : sessions_) {
    if (now - session.last_message_tick > longest_silence_ticks_) {
      note(*session.outlet,
           "stopped reporting after its sample " + std::to_string(capture.last_report_sample(id)));
    }
  }
}

}  // namespace gsbench::station

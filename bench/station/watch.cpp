#include "watch.hpp"

#include "faults.hpp"

#include <algorithm>

#include <waveform/tick.hpp>

namespace gsbench::station {
namespace {

// An outlet reports every 16 ms. A longer silence than a source's buffer and a link's delay explain
// would pass for good behaviour: an outlet that says nothing has no event either.
constexpr double kLongestSilenceS = 1.0;

}  // namespace

void Watch::hear(std::vector<link::Received>& messages, std::int64_t now) {
  const auto of_second_life = [&](const link::Received& received) {
    if (received.outlet >= lives_.size()) {
      return false;
    }
    const gs::wire::Uplink& message = received.message;
    Life& life = lives_[received.outlet];
    life.heard_tick = now;
    if (message.kind == gs::wire::UplinkKind::kError && spoils_a_run(message.error.code)) {
      note(outlets_[received.outlet],
           std::string("tells: ") + gs::wire::to_string(message.error.code));
    }
    life.over = life.over || message.sample < life.newest_sample;
    life.newest_sample = message.sample;
    return life.over;
  };
  messages.erase(std::remove_if(messages.begin(), messages.end(), of_second_life), messages.end());
}

void Watch::note_faults(const std::vector<link::Fault>& faults) {
  for (const link::Fault& fault : faults) {
    if (fault.outlet < outlets_.size()) {
      note(outlets_[fault.outlet], fault.what);
    }
  }
}

void Watch::check_answers(const capture::Capture& capture) {
  for (std::size_t i = 0; i < outlets_.size(); ++i) {
    const capture::SettingsAnswer& answer = capture.settings_answer(i);
    if (!answer.came) {
      note(outlets_[i], "did not answer to its settings");
    } else if (!answer.accepted) {
      note(outlets_[i], "refused its settings: " + answer.reason);
    }
    const std::string failed = failed_parts(capture.self_test_failed(i));
    if (!failed.empty()) {
      note(outlets_[i], "fails its self test: " + failed);
    }
  }
}

void Watch::check_silence(const capture::Capture& capture, std::int64_t now) {
  const std::int64_t longest = waveform::tick_at(kLongestSilenceS, sample_rate_hz_);
  for (std::size_t i = 0; i < outlets_.size(); ++i) {
    if (now - lives_[i].heard_tick > longest) {
      note(outlets_[i],
           "fell silent after its sample " + std::to_string(capture.last_report_sample(i)));
    }
  }
}

}  // namespace gsbench::station

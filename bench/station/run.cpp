#include "comparisons.hpp"
#include "identity.hpp"
#include "stimulus_marks.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <capture/capture.hpp>
#include <capture/truth_trace.hpp>
#include <judge/judge.hpp>
#include <station/outlet_settings.hpp>
#include <station/run.hpp>
#include <station/safe_state.hpp>
#include <waveform/tick.hpp>

namespace gsbench::station {
namespace {

using gs::outlet::Settings;
using record::Verdict;

// An outlet must have answered to its settings so soon after the start.
constexpr double kSettingsAnswerS = 0.096;
// It reports every 16 ms. A longer silence than a source's buffer and a link's delay explain would
// pass for good behaviour: an outlet that says nothing has no event either.
constexpr double kLongestSilenceS = 1.0;

// Ends the run with verdict ERROR; never leaves run().
struct BenchFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void require(const drivers::Status& status) {
  if (!status.ok()) {
    throw BenchFault(status.error());
  }
}

std::string noise_text(const profile::Plan& plan, const source::SourceInfo& source) {
  if (!(plan.stimulus.noise_pct > 0.0)) {
    return "none";
  }
  std::string percent = std::to_string(plan.stimulus.noise_pct);
  percent.erase(percent.find_last_not_of('0') + 1);
  if (percent.back() == '.') {
    percent.pop_back();
  }
  return percent + " % white, " +
         (source.noise_per_outlet ? "each outlet its own" : "the same at all outlets");
}

record::RunRecord head(const profile::Plan& plan, Station& station, const waveform::Truth& truth) {
  record::RunRecord run;
  run.run_id = new_run_id();
  run.started_utc = utc_now();
  run.gsbench_version = version();
  run.firmware_sha256 = firmware_sha256();
  run.profile = plan.name;
  run.profile_title = plan.title;
  run.profile_source = plan.source;
  run.profile_sha256 = plan.sha256;
  run.profile_text = plan.text;
  run.grid = plan.grid.name;
  run.station = station.name();
  run.noise = noise_text(plan, station.source().info());
  run.seed = plan.seed;
  run.sample_rate_hz = plan.stimulus.sample_rate_hz;
  run.duration_ticks = plan.duration_ticks();
  run.nominal_hz = plan.grid.nominal_hz;
  run.comparisons = comparisons(plan.grid);
  run.stimulus = stimulus_marks(plan);
  run.truth = capture::truth_trace(truth, plan.duration_ticks(), plan.stimulus.sample_rate_hz);
  return run;
}

// Plays a plan from its first tick to its last.
class Player {
 public:
  Player(const profile::Plan& plan, Station& station, const RunOptions& options,
         capture::Capture& capture)
      : plan_(plan),
        station_(station),
        options_(options),
        capture_(capture),
        synthesizer_(plan.synthesizer()) {}

  void start_source() {
    source::SourceSettings settings;
    settings.sample_rate_hz = plan_.stimulus.sample_rate_hz;
    settings.nominal_hz = static_cast<int>(std::lround(plan_.grid.nominal_hz));
    settings.noise_rms_pu = plan_.stimulus.noise_rms_pu();
    settings.seed = plan_.seed;
    require(station_.source().start(settings));
  }

  // False where it was stopped.
  bool play(const std::vector<record::OutletRecord>& outlets) {
    const std::int64_t end = plan_.duration_ticks();
    std::size_t command = 0;
    bool answers_checked = false;
    for (std::int64_t tick = 0; tick < end;) {
      if (options_.stop != nullptr && options_.stop->load()) {
        return false;
      }
      for (; command < plan_.commands.size() && tick_of(plan_.commands[command].at_s) <= tick;
           ++command) {
        send(plan_.commands[command], tick);
      }
      std::int64_t next = tick + std::max<std::int64_t>(tick_of(station_.block_s()), 1);
      if (!answers_checked) {
        next = std::min(next, tick_of(kSettingsAnswerS));
      }
      if (command < plan_.commands.size()) {
        next = std::min(next, tick_of(plan_.commands[command].at_s));
      }
      next = std::min(next, end);
      play_block(tick, static_cast<std::size_t>(next - tick));
      tick = next;
      if (!answers_checked && tick >= std::min(tick_of(kSettingsAnswerS), end)) {
        check_answers(outlets);
        answers_checked = true;
      }
      check_silence(outlets, tick);
      if (options_.progress) {
        options_.progress(static_cast<double>(tick) / static_cast<double>(end));
      }
    }
    return true;
  }

 private:
  std::int64_t tick_of(double t_s) const {
    return waveform::tick_at(t_s, plan_.stimulus.sample_rate_hz);
  }

  void play_block(std::int64_t tick, std::size_t count) {
    block_.resize(count);
    synthesizer_.render(tick, count, block_.data());
    require(station_.source().play(tick, block_.data(), count));
    messages_.clear();
    edges_.clear();
    require(station_.link().poll(messages_));
    require(station_.relay_sense().poll(edges_));
    capture_.add(messages_);
    capture_.add(edges_);
  }

  void send(const profile::Command& command, std::int64_t tick) {
    gs::wire::Downlink message;
    message.kind = gs::wire::DownlinkKind::kCommand;
    message.close_relay = command.switch_on;
    for (std::size_t i = 0; i < plan_.outlets.size(); ++i) {
      if (command.outlets.empty() ||
          std::count(command.outlets.begin(), command.outlets.end(), plan_.outlets[i].id) > 0) {
        require(station_.link().send(i, message));
        capture_.add_command(i, tick, command.switch_on);
      }
    }
  }

  void check_answers(const std::vector<record::OutletRecord>& outlets) const {
    for (std::size_t i = 0; i < outlets.size(); ++i) {
      const capture::SettingsAnswer& answer = capture_.settings_answer(i);
      if (!answer.came) {
        throw BenchFault("outlet " + outlets[i].id + " did not answer to its settings");
      }
      if (!answer.accepted) {
        throw BenchFault("outlet " + outlets[i].id + " refused its settings: " + answer.reason);
      }
    }
  }

  void check_silence(const std::vector<record::OutletRecord>& outlets, std::int64_t tick) const {
    for (std::size_t i = 0; i < outlets.size(); ++i) {
      const std::int64_t last_tick = capture_.last_report_tick(i);
      if (tick - last_tick > tick_of(kLongestSilenceS)) {
        throw BenchFault("outlet " + outlets[i].id + " fell silent at tick " +
                         std::to_string(last_tick));
      }
    }
  }

  const profile::Plan& plan_;
  Station& station_;
  const RunOptions& options_;
  capture::Capture& capture_;
  waveform::Synthesizer synthesizer_;
  std::vector<float> block_;
  std::vector<link::Received> messages_;
  std::vector<relay::Edge> edges_;
};

std::vector<Settings> settings_for_all(const profile::Plan& plan) {
  std::vector<Settings> all;
  for (const profile::Outlet& outlet : plan.outlets) {
    all.push_back(outlet_settings(plan, outlet, 1));
  }
  return all;
}

std::vector<record::OutletRecord> claim_outlets(const profile::Plan& plan, Station& station,
                                                const std::vector<Settings>& settings) {
  const auto present = station.link().open();
  if (!present.ok()) {
    throw BenchFault(present.error());
  }
  if (present.value().size() < plan.outlets.size()) {
    throw BenchFault("the profile needs " + std::to_string(plan.outlets.size()) +
                     " outlets; the station has " + std::to_string(present.value().size()));
  }
  std::vector<record::OutletRecord> records;
  for (std::size_t i = 0; i < plan.outlets.size(); ++i) {
    const gs::wire::Hello& hello = present.value()[i].hello;
    if (hello.protocol_version != gs::wire::kProtocolVersion) {
      throw BenchFault("outlet " + present.value()[i].id + " speaks protocol " +
                       std::to_string(hello.protocol_version) + ", not " +
                       std::to_string(gs::wire::kProtocolVersion));
    }
    record::OutletRecord record;
    record.id = present.value()[i].id;
    record.group = plan.outlets[i].group;
    record.link = station.link().name();
    record.firmware = std::to_string(hello.firmware_version / 1000000) + "." +
                      std::to_string(hello.firmware_version / 1000 % 1000) + "." +
                      std::to_string(hello.firmware_version % 1000);
    record.settings = described(settings[i]);
    record.settings["tracker_delay_s"] = static_cast<double>(hello.tracker_delay_s);
    records.push_back(record);

    gs::wire::Downlink message;
    message.kind = gs::wire::DownlinkKind::kSettings;
    message.settings = settings[i];
    require(station.link().send(i, message));
  }
  return records;
}

void set_error(record::RunRecord& run, const std::string& reason) {
  run.verdict = Verdict::kError;
  run.verdict_reason = reason;
}

void judge_all(const profile::Plan& plan, const waveform::Truth& truth, Station& station,
               record::RunRecord& run) {
  std::size_t worst = 0;
  for (record::OutletRecord& outlet : run.outlets) {
    judge::judge_outlet(plan, truth, station.uncertainty(), outlet);
    run.verdict = std::max(run.verdict, outlet.verdict);
    worst += outlet.verdict == Verdict::kPass ? 0 : 1;
  }
  if (worst > 0) {
    run.verdict_reason = std::to_string(worst) + " of " + std::to_string(run.outlets.size()) +
                         " outlets did not pass";
  }
}

}  // namespace

record::RunRecord run(const profile::Plan& plan, Station& station, const RunOptions& options) {
  const std::vector<Settings> settings = settings_for_all(plan);
  const std::shared_ptr<const waveform::Truth> truth = plan.truth();
  record::RunRecord run = head(plan, station, *truth);
  capture::Capture capture(plan.outlets.size(), plan.stimulus.sample_rate_hz);
  {
    const SafeState safe_state(station.source(), station.link());
    if (options.writer != nullptr) {
      options.writer->begin(run);
    }
    try {
      Player player(plan, station, options, capture);
      player.start_source();
      run.outlets = claim_outlets(plan, station, settings);
      if (!player.play(run.outlets)) {
        set_error(run, "interrupted before its end");
      }
    } catch (const BenchFault& fault) {
      set_error(run, fault.what());
    }
  }
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    capture.move_into(i, run.outlets[i]);
  }
  if (run.verdict == Verdict::kError) {
    for (record::OutletRecord& outlet : run.outlets) {
      outlet.verdict = Verdict::kError;
    }
  } else {
    judge_all(plan, *truth, station, run);
  }
  run.finished_utc = utc_now();
  if (options.writer != nullptr) {
    for (const record::OutletRecord& outlet : run.outlets) {
      options.writer->add_outlet(outlet);
    }
    options.writer->finish(run);
  }
  return run;
}

}  // namespace gsbench::station

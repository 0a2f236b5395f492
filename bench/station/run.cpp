#include "comparisons.hpp"
#include "identity.hpp"
#include "stimulus_marks.hpp"
#include <control_centre/outlet_settings.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <capture/capture.hpp>
#include <capture/truth_trace.hpp>
#include <judge/judge.hpp>
#include <link/version_text.hpp>
#include <profile/load.hpp>
#include <station/played_signal.hpp>
#include <station/run.hpp>
#include <station/safe_state.hpp>
#include <waveform/tick.hpp>

namespace gsbench::station {
namespace {

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
  run.grid_sha256 = plan.grid.sha256;
  const profile::Recording& recording = plan.stimulus.recording;
  run.recording = {recording.file,
                   recording.sha256,
                   recording.columns.time,
                   recording.columns.frequency,
                   recording.columns.voltage,
                   recording.columns.nominal_voltage,
                   recording.replaces_profile};
  run.station = station.name();
  run.noise = noise_text(plan, station.source().info());
  run.seed = plan.seed;
  run.sample_rate_hz = plan.stimulus.sample_rate_hz;
  run.duration_ticks = plan.duration_ticks();
  run.nominal_hz = plan.grid.nominal_hz;
  run.bench_uncertainty = station.uncertainty();
  run.comparisons = comparisons(plan.grid);
  run.stimulus = stimulus_marks(plan);
  run.truth = capture::truth_trace(truth, plan.duration_ticks(), plan.stimulus.sample_rate_hz);
  return run;
}

// The first fault of an outlet stands; later ones often follow from it.
void note(record::OutletRecord& outlet, const std::string& fault) {
  if (outlet.fault.empty()) {
    outlet.fault = fault;
  }
}

std::string first_fault(const std::vector<record::OutletRecord>& outlets) {
  for (const record::OutletRecord& outlet : outlets) {
    if (!outlet.fault.empty()) {
      return "outlet " + outlet.id + " " + outlet.fault;
    }
  }
  return {};
}

// All but the converter, which may have had nothing to convert yet.
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

// What an outlet tells of itself that makes a run with it worthless. That it did not understand the
// bench shows in what it then does not do.
bool spoils_a_run(gs::wire::ErrorCode error) {
  return error == gs::wire::ErrorCode::kSamplesLost || error == gs::wire::ErrorCode::kWatchdog ||
         error == gs::wire::ErrorCode::kSettingsStorage || error == gs::wire::ErrorCode::kClock;
}

// Plays a plan from its first tick to its last. What goes wrong with one outlet is that outlet's
// fault, and the others go on; what goes wrong with the bench ends the run.
class Player {
 public:
  Player(const profile::Plan& plan, Station& station, const RunOptions& options,
         capture::Capture& capture)
      : plan_(plan),
        station_(station),
        options_(options),
        capture_(capture),
        signal_(plan, !station.outlets_count_ticks()) {}

  void start_source() {
    source::SourceSettings settings;
    settings.sample_rate_hz = plan_.stimulus.sample_rate_hz;
    settings.nominal_hz = static_cast<int>(std::lround(plan_.grid.nominal_hz));
    settings.noise_rms_pu = plan_.stimulus.noise_rms_pu();
    settings.seed = plan_.seed;
    require(station_.source().start(settings));
  }

  const capture::Markers& markers() const { return signal_.markers(); }

  // False where it was stopped.
  bool play(std::vector<record::OutletRecord>& outlets) {
    heard_tick_.assign(outlets.size(), 0);
    lives_.assign(outlets.size(), Life{});
    const std::int64_t lead = signal_.lead_ticks();
    const std::int64_t end = signal_.total_ticks();
    // Where nothing is played before the run, answers come during its first reports.
    const std::int64_t answers_due = std::min(std::max(lead, tick_of(kSettingsAnswerS)), end);
    std::size_t command = 0;
    for (std::int64_t tick = 0; tick < end;) {
      if (options_.stop != nullptr && options_.stop->load()) {
        return false;
      }
      for (; command < plan_.commands.size() && command_tick(command) <= tick; ++command) {
        send(plan_.commands[command], tick);
      }
      std::int64_t next = tick + std::max<std::int64_t>(tick_of(station_.block_s()), 1);
      for (const std::int64_t stop :
           {answers_due, command < plan_.commands.size() ? command_tick(command) : end, end}) {
        next = stop > tick ? std::min(next, stop) : next;
      }
      play_block(tick, static_cast<std::size_t>(next - tick), outlets);
      if (tick < answers_due && next >= answers_due) {
        check_answers(outlets);
      }
      tick = next;
      check_silence(outlets, tick);
      require_an_outlet(outlets);
      if (options_.progress) {
        options_.progress(static_cast<double>(tick) / static_cast<double>(end));
      }
    }
    return true;
  }

 private:
  // An outlet's count of its samples, from its start-up on.
  struct Life {
    std::uint64_t newest_sample = 0;
    bool over = false;
  };

  std::int64_t tick_of(double t_s) const {
    return waveform::tick_at(t_s, plan_.stimulus.sample_rate_hz);
  }

  std::int64_t command_tick(std::size_t command) const {
    return signal_.lead_ticks() + tick_of(plan_.commands[command].at_s);
  }

  void play_block(std::int64_t tick, std::size_t count,
                  std::vector<record::OutletRecord>& outlets) {
    block_.resize(count);
    signal_.render(tick, count, block_.data());
    require(station_.source().play(tick, block_.data(), count));
    messages_.clear();
    faults_.clear();
    edges_.clear();
    require(station_.link().poll(messages_, faults_));
    require(station_.relay_sense().poll(edges_));
    for (relay::Edge& edge : edges_) {
      edge.tick -= signal_.lead_ticks();
    }
    for (const link::Received& received : messages_) {
      if (received.outlet < heard_tick_.size()) {
        heard_tick_[received.outlet] = tick + static_cast<std::int64_t>(count);
        if (received.message.kind == gs::wire::UplinkKind::kError &&
            spoils_a_run(received.message.error.code)) {
          note(outlets[received.outlet],
               std::string("tells: ") + gs::wire::to_string(received.message.error.code));
        }
      }
    }
    leave_out_second_lives();
    capture_.add(messages_);
    capture_.add(edges_);
    for (const link::Fault& fault : faults_) {
      if (fault.outlet < outlets.size()) {
        note(outlets[fault.outlet], fault.what);
      }
    }
  }

  // What an outlet says after it began anew is by another count, which nothing aligns.
  void leave_out_second_lives() {
    const auto of_second_life = [this](const link::Received& received) {
      if (received.outlet >= lives_.size()) {
        return false;
      }
      Life& life = lives_[received.outlet];
      life.over = life.over || received.message.sample < life.newest_sample;
      life.newest_sample = received.message.sample;
      return life.over;
    };
    messages_.erase(std::remove_if(messages_.begin(), messages_.end(), of_second_life),
                    messages_.end());
  }

  void send(const profile::Command& command, std::int64_t tick) {
    gs::wire::Downlink message;
    message.kind = gs::wire::DownlinkKind::kCommand;
    message.close_relay = command.switch_on;
    message.request = ++requests_;
    for (std::size_t i = 0; i < plan_.outlets.size(); ++i) {
      if (command.outlets.empty() ||
          std::count(command.outlets.begin(), command.outlets.end(), plan_.outlets[i].id) > 0) {
        require(station_.link().send(i, message));
        capture_.add_command(i, tick - signal_.lead_ticks(), command.switch_on);
      }
    }
  }

  void check_answers(std::vector<record::OutletRecord>& outlets) const {
    for (std::size_t i = 0; i < outlets.size(); ++i) {
      const capture::SettingsAnswer& answer = capture_.settings_answer(i);
      if (!answer.came) {
        note(outlets[i], "did not answer to its settings");
      } else if (!answer.accepted) {
        note(outlets[i], "refused its settings: " + answer.reason);
      }
      const std::string failed = failed_parts(capture_.self_test_failed(i));
      if (!failed.empty()) {
        note(outlets[i], "fails its self test: " + failed);
      }
    }
  }

  void check_silence(std::vector<record::OutletRecord>& outlets, std::int64_t tick) const {
    for (std::size_t i = 0; i < outlets.size(); ++i) {
      if (tick - heard_tick_[i] > tick_of(kLongestSilenceS)) {
        note(outlets[i],
             "fell silent after its sample " + std::to_string(capture_.last_report_sample(i)));
      }
    }
  }

  static void require_an_outlet(const std::vector<record::OutletRecord>& outlets) {
    if (std::all_of(outlets.begin(), outlets.end(),
                    [](const record::OutletRecord& o) { return !o.fault.empty(); })) {
      throw BenchFault(first_fault(outlets) + "; no outlet is left");
    }
  }

  const profile::Plan& plan_;
  Station& station_;
  const RunOptions& options_;
  capture::Capture& capture_;
  PlayedSignal signal_;
  std::uint32_t requests_ = 0;
  std::vector<std::int64_t> heard_tick_;  // of the source, when each outlet was last heard
  std::vector<Life> lives_;
  std::vector<float> block_;
  std::vector<link::Received> messages_;
  std::vector<link::Fault> faults_;
  std::vector<relay::Edge> edges_;
};

// Before anything is touched: what the firmware would refuse is the profile's mistake.
void check_settings(const profile::Plan& plan) {
  for (const profile::Outlet& outlet : plan.outlets) {
    try {
      control_centre::outlet_settings(plan.grid, outlet.settings, 1);
    } catch (const std::invalid_argument& error) {
      throw profile::ConfigurationError(plan.path + ": outlet " + outlet.id + ": " + error.what());
    }
  }
}

record::OutletRecord claim(const profile::Plan& plan, std::size_t i,
                           const link::OutletPresence& present, link::Link& link) {
  const gs::wire::Hello& hello = present.hello;
  record::OutletRecord record;
  record.id = present.id;
  record.group = plan.outlets[i].group;
  record.link = present.where;
  if (!present.fault.empty()) {
    note(record, present.fault);
    return record;
  }
  record.firmware = link::version_text(hello.firmware_version);
  if (hello.sample_rate_hz != plan.stimulus.sample_rate_hz ||
      hello.nominal_hz != static_cast<std::int32_t>(std::lround(plan.grid.nominal_hz))) {
    note(record, "samples at " + std::to_string(hello.sample_rate_hz) + " Hz for mains of " +
                     std::to_string(hello.nominal_hz) + " Hz, which is not the profile's");
    return record;
  }
  record.took_part = true;
  // An outlet takes no settings that are older than those it has.
  gs::wire::Downlink message;
  message.kind = gs::wire::DownlinkKind::kSettings;
  message.settings = control_centre::outlet_settings(plan.grid, plan.outlets[i].settings,
                                                     hello.settings_version + 1);
  record.settings = control_centre::described(message.settings);
  record.settings["tracker_delay_s"] = static_cast<double>(hello.tracker_delay_s);
  record.settings["voltage_delay_s"] = static_cast<double>(hello.voltage_delay_s);
  require(link.send(i, message));
  message.kind = gs::wire::DownlinkKind::kAskSelfTest;
  require(link.send(i, message));
  return record;
}

std::vector<record::OutletRecord> claim_outlets(const profile::Plan& plan, Station& station) {
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
    records.push_back(claim(plan, i, present.value()[i], station.link()));
  }
  return records;
}

// Brings what an outlet said onto the run's time base, into its record.
void collect(std::size_t i, const Station& station, const capture::Markers& markers,
             const record::RunRecord& run, capture::Capture& capture,
             record::OutletRecord& outlet) {
  capture::OutletClock clock;
  if (!station.outlets_count_ticks()) {
    const auto delay_s = outlet.settings.find("voltage_delay_s");
    if (delay_s == outlet.settings.end()) {
      return;  // it was not spoken to: what it said may mean anything
    }
    const auto rate_hz = static_cast<double>(run.sample_rate_hz);
    capture::VoltageTrace voltage = capture.voltage_trace(i);
    voltage.window_samples = 2.0 * delay_s->second * rate_hz;
    const auto alignment = capture::align(voltage, markers, rate_hz);
    if (alignment) {
      clock = alignment->clock;
      outlet.clock = alignment->told;
    } else if (!run.interrupted) {
      note(outlet, "did not show the marks before the run in its voltage: its time is not known");
    }
  }
  capture.move_into(i, clock, run.duration_ticks, outlet);
}

}  // namespace

record::RunRecord run(const profile::Plan& plan, Station& station, const RunOptions& options) {
  check_settings(plan);
  const std::shared_ptr<const waveform::Truth> truth = plan.truth();
  record::RunRecord run = head(plan, station, *truth);
  capture::Capture capture(plan.outlets.size(), plan.stimulus.sample_rate_hz);
  Player player(plan, station, options, capture);
  {
    const SafeState safe_state(station.source(), station.link());
    if (options.writer != nullptr) {
      options.writer->begin(run);
    }
    try {
      player.start_source();
      run.outlets = claim_outlets(plan, station);
      if (!player.play(run.outlets)) {
        run.interrupted = true;
      }
    } catch (const BenchFault& fault) {
      run.fault = fault.what();
    }
  }
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    collect(i, station, player.markers(), run, capture, run.outlets[i]);
  }
  judge::judge(plan, run);
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

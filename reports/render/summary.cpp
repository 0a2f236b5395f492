#include "summary.hpp"

#include "format.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include <fmt/format.h>

namespace gsbench::render {
namespace {

const char* plural(std::size_t count) {
  return count == 1 ? "" : "s";
}

std::vector<std::string> how_played(const record::RunRecord& run) {
  std::vector<std::string> lines;
  for (std::size_t from = 0; from < run.source.how.size();) {
    const std::size_t end = std::min(run.source.how.find('\n', from), run.source.how.size());
    lines.push_back(valid_text(run.source.how.substr(from, end - from)));
    from = end + 1;
  }
  return lines;
}

// "0.25 mHz, 1.5 %, 0.12 ms".
std::string deviations(const record::RunRecord& run) {
  const record::BenchUncertainty& played = run.bench_uncertainty;
  return fmt::format("{}, {}, {}", with_unit(figure(played.frequency_mhz, 2), "mHz"),
                     with_unit(figure(played.voltage_pct, 2), "%"),
                     with_unit(figure(played.time_ms, 2), "ms"));
}

std::string column_of(const std::string& column) {
  const std::optional<std::uint64_t> number = column_number(column);
  return number ? std::to_string(*number) : column;
}

}  // namespace

std::vector<Shortfall> shortfalls(const View& view) {
  std::vector<Shortfall> first;  // of each measure
  std::vector<Shortfall> more;
  std::set<std::string> measures;
  for (const std::size_t index : worst_first(view)) {
    const record::OutletRecord& outlet = view.run.outlets[index];
    for (const record::MeasurementResult& result : outlet.measurements) {
      if (result.judged && result.verdict != record::Verdict::kPass) {
        (measures.insert(result.name).second ? first : more).push_back({&outlet, &result});
      }
    }
  }
  for (std::vector<Shortfall>* part : {&first, &more}) {
    std::stable_sort(part->begin(), part->end(), [](const Shortfall& a, const Shortfall& b) {
      return a.result->verdict > b.result->verdict;
    });
  }
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

std::string shortfall_text(const record::MeasurementResult& result) {
  std::string text = value_of(result);
  const std::string asked = limits(result);
  if (!asked.empty()) {
    text += ", limit " + asked;
  }
  if (!result.reason.empty()) {
    text += ": " + result.reason;
  }
  return text;
}

std::string outlet_sentence(const record::OutletRecord& outlet) {
  return outlet.fault.empty() ? "the outlet as a whole" : "it " + valid_text(outlet.fault);
}

bool has_sent_hello(const record::OutletRecord& outlet) {
  return outlet.protocol_version != 0;
}

std::vector<const record::OutletRecord*> faulty_outlets(const View& view) {
  std::vector<const record::OutletRecord*> faulty;
  for (const std::size_t index : view.outlets) {
    const record::OutletRecord& outlet = view.run.outlets[index];
    if (!outlet.fault.empty()) {
      faulty.push_back(&outlet);
    }
  }
  return faulty;
}

std::string played_sentence(const record::RunRecord& run) {
  const record::Recording& recording = run.recording;
  if (recording.file.empty()) {
    return "";
  }
  std::string columns = fmt::format("time: column {}, frequency: column {}",
                                    column_of(recording.time), column_of(recording.frequency));
  if (!recording.voltage.empty()) {
    columns += ", voltage: column " + column_of(recording.voltage);
  }
  const std::string what =
      fmt::format("The recording {} ({}; SHA-256 {})", recording.file, columns, recording.sha256);
  return valid_text(recording.replaces_profile
                        ? what +
                              " was played in place of the losses, frequency points or recording, "
                              "oscillations, tones, flicker, amplitude steps and phase steps of "
                              "this profile."
                        : what + " is its [signal.trace].");
}

std::string played_part(const record::RunRecord& run) {
  const record::Recording& recording = run.recording;
  if (recording.file.empty() || recording.rows == 0) {
    return "";
  }
  std::string text = fmt::format(
      "Played: {} rows, {} of them gaps, {:.6g} s.", recording.rows, recording.gaps,
      static_cast<double>(run.duration_ticks) / static_cast<double>(run.sample_rate_hz));
  std::string options;
  for (const auto& [key, value] : recording_options(recording)) {
    options += fmt::format("{}{} = {}", options.empty() ? "" : ", ", key, value);
  }
  if (!options.empty()) {
    text += " Read with " + options + '.';
  }
  return valid_text(text);
}

std::vector<std::pair<std::string, std::string>> recording_options(
    const record::Recording& recording) {
  std::vector<std::pair<std::string, std::string>> options;
  std::istringstream lines(recording.options);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t sign = line.find(" = ");
    const std::string key = line.substr(0, std::min(sign, line.size()));
    if (sign != std::string::npos && key != "time" && key != "frequency" && key != "voltage") {
      options.emplace_back(key, line.substr(sign + 3));
    }
  }
  return options;
}

std::optional<std::uint64_t> column_number(const std::string& column) {
  constexpr std::size_t kMostDigits = 7;
  if (column.size() < 2 || column.size() > kMostDigits || column[0] != '#' ||
      column.find_first_not_of("0123456789", 1) != std::string::npos) {
    return std::nullopt;
  }
  return std::stoull(column.substr(1));
}

std::vector<std::string> source_lines(const record::RunRecord& run) {
  if (run.source.accuracy.empty()) {
    return {};
  }
  std::vector<std::string> lines = {valid_text(run.source.name)};
  for (const std::string& line : how_played(run)) {
    lines.push_back(line);
  }
  lines.push_back(fmt::format("Largest deviations from the profile: {} ({})", deviations(run),
                              valid_text(run.source.accuracy)));
  return lines;
}

std::vector<std::string> source_in_short(const record::RunRecord& run) {
  if (run.source.accuracy.empty()) {
    return {};
  }
  const std::vector<std::string> how = how_played(run);
  return {
      fmt::format("Source: {}{}", valid_text(run.source.name), how.empty() ? "" : ": " + how[0]),
      fmt::format("At most {} from the profile; {}", deviations(run),
                  valid_text(run.source.accuracy))};
}

bool has_clocks(const record::RunRecord& run) {
  return !run.clocks.empty() &&
         (!run.source.accuracy.empty() ||
          std::any_of(run.outlets.begin(), run.outlets.end(),
                      [](const auto& outlet) { return outlet.clock.uncertainty_ms > 0.0; }));
}

std::string clock_uncertainty(const record::AlignedClock& clock) {
  return clock.uncertainty_ms > 0.0 ? "± " + with_unit(figure(clock.uncertainty_ms, 2), "ms")
                                    : "exact";
}

std::string verdict_sentence(const record::RunRecord& run) {
  std::size_t judged = 0;
  for (const record::OutletRecord& outlet : run.outlets) {
    judged += static_cast<std::size_t>(
        std::count_if(outlet.measurements.begin(), outlet.measurements.end(),
                      [](const auto& result) { return result.judged; }));
  }
  if (!run.verdict_reason.empty()) {
    return valid_text(run.verdict_reason);
  }
  if (!run.fault.empty()) {
    return valid_text(run.fault);
  }
  const std::size_t outlets = run.outlets.size();
  const std::size_t short_of = shortfalls(run).size();
  if (short_of > 0) {
    return fmt::format("{} of {} judged measurements on {} outlet{} did not pass.", short_of,
                       judged, outlets, plural(outlets));
  }
  if (judged == 0) {
    return "Nothing was judged.";
  }
  if (judged == 1) {
    return "The only judged measurement is within limits.";
  }
  return fmt::format("All {} judged measurements on {} outlet{} are within limits.", judged,
                     outlets, plural(outlets));
}

}  // namespace gsbench::render

#include "format.hpp"
#include "html_elements.hpp"
#include "plot_data.hpp"
#include "summary.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace gsbench::render {
namespace {

using record::Verdict;

constexpr std::size_t kMostId = 200;  // bytes, as below
constexpr std::size_t kMeasurementMarkup = 450;
constexpr std::size_t kMarkMarkup = 230;
constexpr std::size_t kSettingMarkup = 50;

std::string shown_value(const record::MeasurementResult& result) {
  return result.text.empty() ? typographic(clipped(value_of(result))) : clipped(result.text);
}

object key_cell(const record::OutletRecord& outlet, const KeyColumn& column, std::size_t row) {
  const record::MeasurementResult* result = find_measurement(outlet, column.measure);
  object cell{{"heading", clipped(column.heading_in_one_line())}, {"missed", flag(false)}};
  cell["text"] = typographic(clipped(column.cells[row]));
  cell["missed"] = flag(result != nullptr && result->judged && result->verdict != Verdict::kPass);
  return cell;
}

object measurement_row(const record::MeasurementResult& result) {
  object row{{"name", clipped(result.name)},
             {"definition", clipped(result.definition)},
             {"value", shown_value(result)},
             {"limits", result.judged ? typographic(clipped(limits(result)))
                                      : std::string("for information")},
             {"judged", flag(result.judged)},
             {"reason", clipped(result.reason)},
             {"has_reason", flag(!result.reason.empty())}};
  set_verdict(row, result.verdict);
  return row;
}

// If there is no room for all, those that did not pass come first.
List measurement_rows(const record::OutletRecord& outlet, std::size_t most) {
  std::vector<const record::MeasurementResult*> results;
  for (const record::MeasurementResult& result : outlet.measurements) {
    results.push_back(&result);
  }
  const auto make = [&](std::size_t i) { return measurement_row(*results[i]); };
  List rows = rows_within(most, kMeasurementMarkup, results.size(), make);
  if (rows.size() < results.size()) {
    std::stable_partition(results.begin(), results.end(), [](const auto* result) {
      return result->judged && result->verdict != Verdict::kPass;
    });
    rows = rows_within(most, kMeasurementMarkup, results.size(), make);
  }
  return rows;
}

List mark_rows(const record::RunRecord& run, const record::OutletRecord& outlet, std::size_t most) {
  const std::size_t count = std::min(outlet.reports.marks.size(), kMostMarks);
  return rows_within(most, kMarkMarkup, count, [&](std::size_t i) {
    const record::Mark& mark = outlet.reports.marks[i];
    return object{{"time", fmt::format("{:.4f} s", seconds(run, mark.tick))},
                  {"label", clipped(mark_label(mark))},
                  {"value", typographic(clipped(mark_value(mark)))},
                  {"text", clipped(mark_note(mark))}};
  });
}

List setting_rows(const record::OutletRecord& outlet, std::size_t most) {
  auto setting = outlet.settings.begin();
  return rows_within(most, kSettingMarkup, outlet.settings.size(), [&](std::size_t) {
    const auto& [name, value] = *setting++;
    return object{{"name", clipped(name)}, {"value", typographic(figure(value, 7))}};
  });
}

std::string clock_text(const record::Clock& clock) {
  if (clock.uncertainty_ms == 0.0 && clock.drift_uncertainty_ppm == 0.0) {
    return "that of the source";
  }
  const int decimals = decimals_of_two_digits(clock.drift_uncertainty_ppm);
  return typographic(fmt::format("{} ± {} ppm fast, time stamps within ± {}",
                                 fixed(clock.drift_ppm, decimals),
                                 fixed(clock.drift_uncertainty_ppm, decimals),
                                 with_unit(figure(clock.uncertainty_ms, 2), "ms")));
}

}  // namespace

object overview_row(const record::OutletRecord& outlet, const std::vector<KeyColumn>& columns,
                    std::size_t row, std::optional<std::size_t> drawn) {
  List cells;
  for (const KeyColumn& column : columns) {
    cells.push_back(key_cell(outlet, column, row));
  }
  object view{{"id", clipped(outlet.id, kMostId)}, {"cells", cells}, {"drawn", flag(!!drawn)}};
  view["index"] = std::to_string(drawn.value_or(0));
  set_verdict(view, outlet.verdict);
  return view;
}

object outlet_object(const record::RunRecord& run, const record::OutletRecord& outlet,
                     std::size_t drawn, std::size_t most) {
  // Of ten parts six are for measurements, three for marks and one for settings.
  const List measurements = measurement_rows(outlet, most / 10 * 6);
  const List marks = mark_rows(run, outlet, most / 10 * 3);
  const List settings = setting_rows(outlet, most / 10);
  const auto or_unknown = [](const std::string& text) {
    return text.empty() ? std::string("not known") : clipped(text, kMostId);
  };
  const auto number = [&](std::uint64_t of_outlet) {
    return or_unknown(has_sent_hello(outlet) ? std::to_string(of_outlet) : "");
  };
  object view{
      {"id", clipped(outlet.id, kMostId)},
      {"index", std::to_string(drawn)},
      {"group", clipped(outlet.group, kMostId)},
      {"link", clipped(outlet.link, kMostId)},
      {"board", or_unknown(outlet.board)},
      {"instance", number(outlet.instance)},
      {"firmware", or_unknown(outlet.firmware)},
      {"build", or_unknown(outlet.build)},
      {"protocol", number(outlet.protocol_version)},
      {"settings_digest", or_unknown(outlet.settings_digest)},
      {"fault", clipped(outlet.fault)},
      {"has_fault", flag(!outlet.fault.empty())},
      {"clock", clock_text(outlet.clock)},
      {"open", flag(outlet.verdict != Verdict::kPass)},
      {"measurements", measurements},
      {"has_measurements", flag(!outlet.measurements.empty())},
      {"more_measurements", flag(measurements.size() < outlet.measurements.size())},
      {"measurements_in_all", std::to_string(outlet.measurements.size())},
      {"marks", marks},
      {"has_marks", flag(!outlet.reports.marks.empty())},
      {"more_marks", flag(marks.size() < outlet.reports.marks.size())},
      {"marks_in_all", std::to_string(outlet.reports.marks.size())},
      {"settings", settings},
      {"more_settings", flag(settings.size() < outlet.settings.size())},
      {"settings_in_all", std::to_string(outlet.settings.size())},
  };
  set_verdict(view, outlet.verdict);
  return view;
}

}  // namespace gsbench::render

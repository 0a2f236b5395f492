#include "format.hpp"
#include "html_elements.hpp"
#include "plot_data.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace gsbench::render {
namespace {

using record::Verdict;

std::string shown_value(const record::MeasurementResult& result) {
  return result.text.empty() ? typographic(valid_text(value_of(result))) : valid_text(result.text);
}

object key_cell(const record::OutletRecord& outlet, const KeyColumn& column, std::size_t index) {
  const record::MeasurementResult* result = find_measurement(outlet, column.measure);
  object cell{{"heading", valid_text(column.heading_in_one_line())}, {"missed", flag(false)}};
  cell["text"] = typographic(valid_text(column.cells[index]));
  cell["missed"] = flag(result != nullptr && result->judged && result->verdict != Verdict::kPass);
  return cell;
}

List measurement_rows(const record::OutletRecord& outlet) {
  List list;
  for (const record::MeasurementResult& result : outlet.measurements) {
    object row{{"name", valid_text(result.name)},
               {"definition", valid_text(result.definition)},
               {"value", shown_value(result)},
               {"limits", result.judged ? typographic(valid_text(limits(result)))
                                        : std::string("for information")},
               {"judged", flag(result.judged)},
               {"reason", valid_text(result.reason)},
               {"has_reason", flag(!result.reason.empty())}};
    set_verdict(row, result.verdict);
    list.push_back(row);
  }
  return list;
}

List mark_rows(const record::RunRecord& run, const record::OutletRecord& outlet) {
  List list;
  for (std::size_t i = 0; i < std::min(outlet.marks.size(), kMostMarks); ++i) {
    const record::Mark& mark = outlet.marks[i];
    list.push_back(object{{"time", fmt::format("{:.4f} s", seconds(run, mark.tick))},
                          {"label", valid_text(mark_label(mark))},
                          {"value", typographic(mark_value(mark))},
                          {"text", valid_text(mark.text)}});
  }
  return list;
}

List setting_rows(const record::OutletRecord& outlet) {
  List list;
  for (const auto& [name, value] : outlet.settings) {
    list.push_back(object{{"name", valid_text(name)}, {"value", typographic(figure(value, 7))}});
  }
  return list;
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

object outlet_object(const record::RunRecord& run, std::size_t index,
                     const std::vector<KeyColumn>& columns) {
  const record::OutletRecord& outlet = run.outlets[index];
  List cells;
  for (const KeyColumn& column : columns) {
    cells.push_back(key_cell(outlet, column, index));
  }
  object view{{"id", valid_text(outlet.id)},
              {"index", std::to_string(index)},
              {"group", valid_text(outlet.group)},
              {"link", valid_text(outlet.link)},
              {"firmware", valid_text(outlet.firmware)},
              {"settings_digest", valid_text(outlet.settings_digest)},
              {"fault", valid_text(outlet.fault)},
              {"has_fault", flag(!outlet.fault.empty())},
              {"clock", clock_text(outlet.clock)},
              {"open", flag(outlet.verdict != Verdict::kPass)},
              {"cells", cells},
              {"measurements", measurement_rows(outlet)},
              {"marks", mark_rows(run, outlet)},
              {"has_marks", flag(!outlet.marks.empty())},
              {"more_marks", flag(outlet.marks.size() > kMostMarks)},
              {"marks_in_all", std::to_string(outlet.marks.size())},
              {"settings", setting_rows(outlet)},
              {"has_settings", flag(!outlet.settings.empty())}};
  set_verdict(view, outlet.verdict);
  return view;
}

}  // namespace gsbench::render

#include "format.hpp"
#include "key_figures.hpp"
#include "plot_data.hpp"
#include "summary.hpp"
#include "templates.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <kainjow/mustache.hpp>

#include <record/store.hpp>
#include <render/render.hpp>

namespace gsbench::render {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::object;
using List = kainjow::mustache::list;
using record::Verdict;

constexpr std::size_t kMostColumns = 9;      // beside name and verdict: fits 1280 pixels and A4
constexpr std::size_t kMostShortfalls = 20;  // the tables below have all

// A template's section takes an empty text for true; a flag says what it is.
data flag(bool value) {
  return value ? data::type::bool_true : data::type::bool_false;
}

struct VerdictLook {
  const char* css_class;
  const char* sign;
};

VerdictLook look_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return {"pass", "✓"};
    case Verdict::kInconclusive:
      return {"inconclusive", "?"};
    case Verdict::kFail:
      return {"fail", "✕"};
    case Verdict::kError:
      break;
  }
  return {"error", "!"};
}

void set_verdict(object& where, Verdict verdict) {
  where["verdict"] = std::string(record::to_string(verdict));
  where["class"] = std::string(look_of(verdict).css_class);
  where["sign"] = std::string(look_of(verdict).sign);
}

// A page's typographic minus; only what was formatted here passes through.
std::string typographic(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at)) {
    const bool before_digit = at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9';
    const bool after_gap = at == 0 || text[at - 1] == ' ';
    if (before_digit && after_gap) text.replace(at, 1, "−");
    ++at;
  }
  return text;
}

std::string shown_value(const record::MeasurementResult& result) {
  return result.word.empty() ? typographic(valid_text(value_of(result))) : valid_text(result.word);
}

List facts(const record::RunRecord& run) {
  List list;
  const auto add = [&](const char* name, const std::string& value, bool code = false) {
    if (value.empty()) return;
    list.push_back(
        object{{"name", std::string(name)}, {"value", valid_text(value)}, {"code", flag(code)}});
  };
  const double duration_s = seconds(run, run.duration_ticks);
  add("Profile", run.profile);
  add("Source", run.profile_source);
  add("Grid", run.grid);
  add("Recording", run.recording.file);
  add("Station", run.station);
  add("Noise", run.noise);
  add("Duration", with_unit(figure(duration_s), "s") + " at " +
                      with_unit(std::to_string(run.sample_rate_hz), "samples/s"));
  add("Outlets", std::to_string(run.outlets.size()));
  add("Seed", std::to_string(run.seed));
  add("Started", run.started_utc);
  add("Finished", run.finished_utc);
  add("gsbench", run.gsbench_version);
  add("Run", run.run_id, true);
  add("Firmware SHA-256", run.firmware_sha256, true);
  add("Profile SHA-256", run.profile_sha256, true);
  add("Grid SHA-256", run.grid_sha256, true);
  add("Recording SHA-256", run.recording.sha256, true);
  add("Content SHA-256", record::content_digest(run), true);
  return list;
}

List fault_rows(const std::vector<const record::OutletRecord*>& faulty) {
  List list;
  for (std::size_t i = 0; i < std::min(faulty.size(), kMostShortfalls); ++i) {
    object row{{"outlet", valid_text(faulty[i]->id)}, {"text", outlet_sentence(*faulty[i])}};
    set_verdict(row, faulty[i]->verdict);
    list.push_back(row);
  }
  return list;
}

List shortfall_rows(const std::vector<Shortfall>& all) {
  List list;
  for (std::size_t i = 0; i < std::min(all.size(), kMostShortfalls); ++i) {
    object row{{"outlet", valid_text(all[i].outlet->id)},
               {"name", valid_text(all[i].result->name)},
               {"text", typographic(valid_text(shortfall_text(*all[i].result)))}};
    set_verdict(row, all[i].result->verdict);
    list.push_back(row);
  }
  return list;
}

object key_cell(const record::OutletRecord& outlet, const KeyFigure& key) {
  const record::MeasurementResult* result = find_measurement(outlet, key.measurement);
  object cell{{"heading", std::string(key.heading)}, {"missed", flag(false)}};
  cell["text"] = typographic(valid_text(key_text(outlet, key)));
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
    return "the source's own ticks";
  }
  return typographic(fmt::format("{} ± {} ppm fast, stamps within {}", figure(clock.drift_ppm, 3),
                                 figure(clock.drift_uncertainty_ppm, 2),
                                 with_unit(figure(clock.uncertainty_ms, 2), "ms")));
}

object outlet_object(const record::RunRecord& run, std::size_t index,
                     const std::vector<KeyFigure>& keys) {
  const record::OutletRecord& outlet = run.outlets[index];
  List cells;
  for (const KeyFigure& key : keys) {
    cells.push_back(key_cell(outlet, key));
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

std::string percent(double value) {
  return std::isfinite(value) ? fmt::format("{:+.2f} %", value) : "–";
}

List comparison_rows(const record::RunRecord& run) {
  List list;
  for (const record::Comparison& comparison : run.comparisons) {
    const std::string unit = valid_text(comparison.unit);
    const double difference_pct =
        100.0 * (comparison.ours - comparison.published) / std::abs(comparison.published);
    list.push_back(object{{"name", valid_text(comparison.name)},
                          {"ours", typographic(with_unit(figure(comparison.ours), unit))},
                          {"published", typographic(with_unit(figure(comparison.published), unit))},
                          {"difference", typographic(percent(difference_pct))},
                          {"note", valid_text(comparison.note)}});
  }
  return list;
}

// A text within a CSS string, in which anything may be written as its code.
std::string css_text(const std::string& text) {
  std::string css;
  for (const char character : text) {
    const bool plain = (character >= '0' && character <= '9') ||
                       (character >= 'A' && character <= 'Z') ||
                       (character >= 'a' && character <= 'z') || character == '-';
    css += plain ? std::string(1, character)
                 : fmt::format("\\{:02x} ", static_cast<unsigned char>(character));
  }
  return css;
}

// The outlet whose curves are drawn first: the first of those that did worst.
std::size_t outlet_drawn_first(const record::RunRecord& run) {
  const auto worst =
      std::max_element(run.outlets.begin(), run.outlets.end(),
                       [](const auto& a, const auto& b) { return a.verdict < b.verdict; });
  return static_cast<std::size_t>(worst - run.outlets.begin());
}

object page(const record::RunRecord& run) {
  const std::vector<KeyFigure> keys = key_figures(run, kMostColumns);
  const std::vector<Shortfall> missed = shortfalls(run);
  const std::vector<const record::OutletRecord*> faulty = faulty_outlets(run);
  List headings;
  for (const KeyFigure& key : keys) {
    headings.push_back(object{{"heading", std::string(key.heading)}});
  }
  List outlets;
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    outlets.push_back(outlet_object(run, i, keys));
  }
  const std::string note = thinning_note(run);
  const std::string doubt = doubt_note(run);
  const std::string played = played_sentence(run);
  object view{{"title", valid_text(run.profile_title.empty() ? run.profile : run.profile_title)},
              {"profile", valid_text(run.profile)},
              {"run_id", valid_text(run.run_id)},
              {"run_id_css", css_text(run.run_id)},
              {"sentence", verdict_sentence(run)},
              {"facts", facts(run)},
              {"has_missed", flag(!missed.empty() || !faulty.empty())},
              {"faults", fault_rows(faulty)},
              {"missed", shortfall_rows(missed)},
              {"more_missed", flag(missed.size() > kMostShortfalls)},
              {"missed_in_all", std::to_string(missed.size())},
              {"headings", headings},
              {"doubt_note", doubt.empty() ? "" : ". " + doubt},
              {"outlets", outlets},
              {"has_outlets", flag(!run.outlets.empty())},
              {"drawn_first", std::to_string(outlet_drawn_first(run))},
              {"has_comparisons", flag(!run.comparisons.empty())},
              {"comparisons", comparison_rows(run)},
              {"has_thinning_note", flag(!note.empty())},
              {"thinning_note", note},
              {"profile_heading", std::string(run.recording.replaces_profile
                                                  ? "The profile, and what was played in its place"
                                                  : "The profile as it was played")},
              {"has_played", flag(!played.empty())},
              {"played", played},
              {"profile_text", valid_text(run.profile_text)},
              {"plot_data", plot_data(run)},
              {"report_css", std::string(templates::report_css)},
              {"report_js", std::string(templates::report_js)},
              {"dygraphs_js", std::string(templates::dygraphs_js)},
              {"dygraphs_css", std::string(templates::dygraphs_css)},
              {"dygraphs_licence", std::string(templates::dygraphs_licence)}};
  set_verdict(view, run.verdict);
  return view;
}

}  // namespace

std::string html(const record::RunRecord& run) {
  kainjow::mustache::mustache report{std::string(templates::report_html)};
  return report.render(data(page(run)));
}

}  // namespace gsbench::render

#include "format.hpp"
#include "html_elements.hpp"
#include "plot_data.hpp"
#include "summary.hpp"
#include "templates.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

constexpr std::size_t kMostHtmlColumns = 9;      // beside name and verdict: fits 1280 pixels and A4
constexpr std::size_t kMostHtmlShortfalls = 20;  // the tables of the outlets have all

List facts(const record::RunRecord& run) {
  List list;
  const auto add = [&](const char* name, const std::string& value, bool code = false) {
    if (value.empty()) {
      return;
    }
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
  add("Content SHA-256", run.content_sha256, true);
  return list;
}

List fault_rows(const std::vector<const record::OutletRecord*>& faulty) {
  List list;
  for (std::size_t i = 0; i < std::min(faulty.size(), kMostHtmlShortfalls); ++i) {
    object row{{"outlet", valid_text(faulty[i]->id)}, {"text", outlet_sentence(*faulty[i])}};
    set_verdict(row, faulty[i]->verdict);
    list.push_back(row);
  }
  return list;
}

List shortfall_rows(const std::vector<Shortfall>& all) {
  List list;
  for (std::size_t i = 0; i < std::min(all.size(), kMostHtmlShortfalls); ++i) {
    object row{{"outlet", valid_text(all[i].outlet->id)},
               {"name", valid_text(all[i].result->name)},
               {"text", typographic(valid_text(shortfall_text(*all[i].result)))}};
    set_verdict(row, all[i].result->verdict);
    list.push_back(row);
  }
  return list;
}

std::string percent(double value) {
  return std::isfinite(value) ? fmt::format("{:+.2f} %", value) : "–";
}

// Figures of one unit have the same decimals.
List comparison_rows(const record::RunRecord& run) {
  List list;
  std::map<std::string, int> decimals;
  for (const record::Comparison& comparison : run.comparisons) {
    int& most = decimals[comparison.unit];
    most = std::max(most, decimals_of_written(comparison.published));
  }
  for (const record::Comparison& comparison : run.comparisons) {
    const std::string unit = valid_text(comparison.unit);
    const double difference_pct =
        100.0 * (comparison.ours - comparison.published) / std::abs(comparison.published);
    const int digits = decimals[comparison.unit];
    const std::string ours = fixed(comparison.ours, digits + 1);
    const std::string published = fixed(comparison.published, digits);
    list.push_back(object{{"name", valid_text(comparison.name)},
                          {"ours", typographic(with_unit(ours, unit))},
                          {"published", typographic(with_unit(published, unit))},
                          {"difference", typographic(percent(difference_pct))},
                          {"note", valid_text(comparison.note)}});
  }
  return list;
}

List clock_rows(const record::RunRecord& run) {
  List list;
  for (const record::AlignedClock& clock : run.clocks) {
    list.push_back(object{{"what", valid_text(clock.what)},
                          {"aligned_by", valid_text(clock.aligned_by)},
                          {"uncertainty", typographic(clock_uncertainty(clock))}});
  }
  return list;
}

List source_rows(const record::RunRecord& run) {
  List list;
  for (const std::string& line : source_lines(run)) {
    list.push_back(object{{"line", typographic(line)}});
  }
  return list;
}

// For a CSS string: every byte but letters, digits and "-" as an escape.
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

// The outlet whose curves are shown first: the first of those with the worst verdict.
std::size_t outlet_drawn_first(const record::RunRecord& run) {
  const auto worst =
      std::max_element(run.outlets.begin(), run.outlets.end(),
                       [](const auto& a, const auto& b) { return a.verdict < b.verdict; });
  return static_cast<std::size_t>(worst - run.outlets.begin());
}

object page(const record::RunRecord& run) {
  const std::vector<KeyColumn> columns = key_columns(run, kMostHtmlColumns);
  const std::vector<Shortfall> missed = shortfalls(run);
  const std::vector<const record::OutletRecord*> faulty = faulty_outlets(run);
  List headings;
  for (const KeyColumn& column : columns) {
    headings.push_back(object{{"heading", valid_text(column.heading_in_one_line())}});
  }
  List outlets;
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    outlets.push_back(outlet_object(run, i, columns));
  }
  const std::string note = thinning_note(run);
  const std::string doubt = doubt_note(run);
  const std::string played = played_sentence(run);
  object view{
      {"title", valid_text(run.profile_title.empty() ? run.profile : run.profile_title)},
      {"profile", valid_text(run.profile)},
      {"run_id", valid_text(run.run_id)},
      {"run_id_css", css_text(run.run_id)},
      {"sentence", verdict_sentence(run)},
      {"facts", facts(run)},
      {"has_missed", flag(!missed.empty() || !faulty.empty())},
      {"faults", fault_rows(faulty)},
      {"missed", shortfall_rows(missed)},
      {"more_missed", flag(missed.size() > kMostHtmlShortfalls)},
      {"missed_in_all", std::to_string(missed.size())},
      {"headings", headings},
      {"doubt_note", doubt.empty() ? "" : ". " + doubt},
      {"outlets", outlets},
      {"has_outlets", flag(!run.outlets.empty())},
      {"drawn_first", std::to_string(outlet_drawn_first(run))},
      {"has_comparisons", flag(!run.comparisons.empty())},
      {"comparisons", comparison_rows(run)},
      {"has_source", flag(!source_lines(run).empty())},
      {"source_lines", source_rows(run)},
      {"has_clocks", flag(has_clocks(run))},
      {"clocks", clock_rows(run)},
      {"has_thinning_note", flag(!note.empty())},
      {"thinning_note", note},
      {"profile_heading",
       std::string(run.recording.replaces_profile
                       ? "The profile, and the recording played in place of its signal"
                       : "The profile")},
      {"has_played", flag(!played.empty())},
      {"played", played},
      {"profile_text", valid_text(run.profile_text)},
      {"plot_data", plot_data(run)},
      {"report_js", std::string(templates::report_js)},
  };
  set_verdict(view, run.verdict);
  return view;
}

}  // namespace

std::string html(const record::RunRecord& run) {
  return filled(templates::report_html, page(run));
}

}  // namespace gsbench::render

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
constexpr std::size_t kMostHtmlShortfalls = 20;  // the tables of the outlets have more
constexpr std::size_t kMostHtmlRows = 1000;
constexpr std::size_t kMostDrawn = 20;

// Bytes; 5 MB together with the texts of the page itself and of Dygraphs.
constexpr std::size_t kMostOverview = 850'000;
constexpr std::size_t kMostDetails = 1'600'000;  // of all outlets
constexpr std::size_t kMostCurves = 1'600'000;   // of all outlets
constexpr std::size_t kMostProfile = 250'000;
constexpr std::size_t kMostRows = 60'000;  // of any other table
constexpr std::size_t kOverviewMarkup = 70;
constexpr std::size_t kRowMarkup = 250;

List facts(const View& shown) {
  const record::RunRecord& run = shown.run;
  List list;
  const auto add = [&](const char* name, const std::string& value, bool code = false) {
    if (value.empty()) {
      return;
    }
    list.push_back(
        object{{"name", std::string(name)}, {"value", clipped(value)}, {"code", flag(code)}});
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
  add("Outlets", shown.outlets.size() == run.outlets.size()
                     ? std::to_string(run.outlets.size())
                     : fmt::format("{} of {}", shown.outlets.size(), run.outlets.size()));
  add("Seed", std::to_string(run.seed));
  add("Started", run.started_utc);
  add("Finished", run.finished_utc);
  add("gsbench", run.gsbench_version);
  add("Software", run.software);
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
    object row{{"outlet", clipped(faulty[i]->id)}, {"text", clipped(outlet_sentence(*faulty[i]))}};
    set_verdict(row, faulty[i]->verdict);
    list.push_back(row);
  }
  return list;
}

List shortfall_rows(const std::vector<Shortfall>& all) {
  List list;
  for (std::size_t i = 0; i < std::min(all.size(), kMostHtmlShortfalls); ++i) {
    object row{{"outlet", clipped(all[i].outlet->id)},
               {"name", clipped(all[i].result->name)},
               {"text", typographic(clipped(shortfall_text(*all[i].result)))}};
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
  std::map<std::string, int> decimals;
  for (const record::Comparison& comparison : run.comparisons) {
    int& most = decimals[comparison.unit];
    most = std::max(most, decimals_of_written(comparison.published));
  }
  return rows_within(kMostRows, kRowMarkup, run.comparisons.size(), [&](std::size_t i) {
    const record::Comparison& comparison = run.comparisons[i];
    const std::string unit = clipped(comparison.unit);
    const double difference_pct =
        100.0 * (comparison.ours - comparison.published) / std::abs(comparison.published);
    const int digits = decimals[comparison.unit];
    const std::string ours = fixed(comparison.ours, digits + 1);
    const std::string published = fixed(comparison.published, digits);
    return object{{"name", clipped(comparison.name)},
                  {"ours", typographic(with_unit(ours, unit))},
                  {"published", typographic(with_unit(published, unit))},
                  {"difference", typographic(percent(difference_pct))},
                  {"note", clipped(comparison.note)}};
  });
}

List clock_rows(const record::RunRecord& run) {
  return rows_within(kMostRows, kRowMarkup, run.clocks.size(), [&](std::size_t i) {
    const record::AlignedClock& clock = run.clocks[i];
    return object{{"what", clipped(clock.what)},
                  {"aligned_by", clipped(clock.aligned_by)},
                  {"uncertainty", typographic(clock_uncertainty(clock))}};
  });
}

List source_rows(const record::RunRecord& run) {
  const std::vector<std::string> lines = source_lines(run);
  return rows_within(kMostRows, kRowMarkup, lines.size(), [&](std::size_t i) {
    return object{{"line", typographic(clipped(lines[i]))}};
  });
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

// The part of the page on its outlets.
void add_outlets(const View& shown, object& page) {
  const record::RunRecord& run = shown.run;
  const std::vector<std::size_t> drawn = worst_first(shown, kMostDrawn);
  std::map<std::size_t, std::size_t> places;
  List outlets;
  std::vector<OutletCurves> curves;
  std::size_t first = 0;  // shown first: the first of those with the worst verdict
  for (std::size_t place = 0; place < drawn.size(); ++place) {
    const record::OutletRecord outlet = shown.marked(drawn[place]);
    outlets.push_back(outlet_object(run, outlet, place, kMostDetails / drawn.size()));
    curves.push_back(curves_of(shown, drawn[place], outlet, kMostCurves / drawn.size()));
    places[drawn[place]] = place;
    if (outlet.verdict > run.outlets[drawn[first]].verdict) {
      first = place;
    }
  }
  const std::vector<std::size_t> listed = worst_first(shown, kMostHtmlRows);
  const Outlets in_rows = outlets_of(run, listed);
  const std::vector<KeyColumn> columns = key_columns(in_rows, kMostHtmlColumns);
  const List rows =
      rows_within(kMostOverview, kOverviewMarkup, listed.size(), [&](std::size_t row) {
        const auto place = places.find(listed[row]);
        return overview_row(*in_rows[row], columns, row,
                            place == places.end() ? std::nullopt : std::optional(place->second));
      });
  List headings;
  for (const KeyColumn& column : columns) {
    headings.push_back(object{{"heading", valid_text(column.heading_in_one_line())}});
  }
  const std::string note = thinning_note(curves);
  const std::string doubt = doubt_note(in_rows);
  page["has_outlets"] = flag(!rows.empty());
  page["headings"] = headings;
  page["doubt_note"] = doubt.empty() ? "" : ". " + doubt;
  page["rows"] = rows;
  page["more_rows"] = flag(rows.size() < shown.outlets.size());
  page["rows_shown"] = std::to_string(rows.size());
  page["outlets"] = outlets;
  page["more_outlets"] = flag(drawn.size() < shown.outlets.size());
  page["outlets_drawn"] = std::to_string(drawn.size());
  page["outlets_in_all"] = std::to_string(shown.outlets.size());
  page["drawn_first"] = std::to_string(first);
  page["has_thinning_note"] = flag(!note.empty());
  page["thinning_note"] = note;
  page["plot_data"] = plot_data(run, curves);
}

object page(const View& shown) {
  const record::RunRecord& run = shown.run;
  const std::vector<Shortfall> missed = shortfalls(shown);
  const std::vector<const record::OutletRecord*> faulty = faulty_outlets(shown);
  const std::string part = played_part(run);
  const std::string played = played_sentence(run) + (part.empty() ? "" : ' ' + part);
  const std::string profile = clipped(run.profile_text, kMostProfile);
  object view{
      {"title", clipped(run.profile_title.empty() ? run.profile : run.profile_title)},
      {"profile", clipped(run.profile)},
      {"run_id", clipped(run.run_id)},
      {"run_id_css", css_text(clipped(run.run_id))},
      {"sentence", clipped(verdict_sentence(run))},
      {"facts", facts(shown)},
      {"has_missed", flag(!missed.empty() || !faulty.empty())},
      {"faults", fault_rows(faulty)},
      {"more_faults", flag(faulty.size() > kMostHtmlShortfalls)},
      {"faults_in_all", std::to_string(faulty.size())},
      {"missed", shortfall_rows(missed)},
      {"more_missed", flag(missed.size() > kMostHtmlShortfalls)},
      {"missed_in_all", std::to_string(missed.size())},
      {"has_comparisons", flag(!run.comparisons.empty())},
      {"comparisons", comparison_rows(run)},
      {"has_source", flag(!source_lines(run).empty())},
      {"source_lines", source_rows(run)},
      {"has_clocks", flag(has_clocks(run))},
      {"clocks", clock_rows(run)},
      {"profile_heading",
       std::string(run.recording.replaces_profile
                       ? "The profile, and the recording played in place of its signal"
                       : "The profile")},
      {"has_played", flag(!played.empty())},
      {"played", clipped(played)},
      {"profile_text", profile},
      {"more_profile", flag(profile != valid_text(run.profile_text))},
      {"profile_bytes", std::to_string(run.profile_text.size())},
      {"report_js", std::string(templates::report_js)},
  };
  add_outlets(shown, view);
  set_verdict(view, run.verdict);
  return view;
}

}  // namespace

std::string html(const View& view) {
  return filled(templates::report_html, page(view));
}

}  // namespace gsbench::render

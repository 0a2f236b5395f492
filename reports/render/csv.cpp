#include "format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

constexpr std::string_view kFourEmpty = ",,,,";

// RFC 4180.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) {
    return text;
  }
  std::string cell = "\"";
  for (const char character : text) {
    if (character == '"') {
      cell += '"';
    }
    cell += character;
  }
  return cell + '"';
}

// The shortest digits that read back as the same number; an empty cell for NaN.
template <class Number>
void add_cell(fmt::memory_buffer& out, Number value) {
  out.push_back(',');
  if (!std::isnan(value)) {
    fmt::format_to(std::back_inserter(out), "{}", value);
  }
}

const char* validity_word(std::uint8_t validity) {
  constexpr std::array kWords = {"invalid", "valid", "held"};
  return validity < kWords.size() ? kWords[validity] : "unknown";
}

// Reports and estimates are merged by tick: an estimate between two reports has a row of its own.
void outlet_rows(const record::RunRecord& run, const record::OutletRecord& outlet,
                 const Sink& sink) {
  constexpr std::size_t kMostBuffered = 1U << 16U;
  fmt::memory_buffer out;
  const std::string id = quoted(outlet.id);
  const record::MeasurementTrace& trace = outlet.trace;
  const record::EstimateTrace& estimates = outlet.estimates;
  constexpr auto kNone = std::numeric_limits<std::int64_t>::max();
  std::size_t report = 0;
  std::size_t estimate = 0;
  while (report < trace.tick.size() || estimate < estimates.tick.size()) {
    const std::int64_t report_tick = report < trace.tick.size() ? trace.tick[report] : kNone;
    const std::int64_t estimate_tick =
        estimate < estimates.tick.size() ? estimates.tick[estimate] : kNone;
    const std::int64_t tick = std::min(report_tick, estimate_tick);
    out.append(id);
    add_cell(out, seconds(run, tick));
    add_cell(out, record::frequency_hz(run.reference, tick));
    if (report < trace.tick.size() && report_tick == tick) {
      add_cell(out, trace.frequency_hz[report]);
      add_cell(out, trace.rocof_hz_s[report]);
      add_cell(out, trace.voltage_pu[report]);
      fmt::format_to(std::back_inserter(out), ",{}", validity_word(trace.validity[report]));
      ++report;
    } else {
      out.append(kFourEmpty);
    }
    if (estimate < estimates.tick.size() && estimate_tick == tick) {
      add_cell(out, estimates.loss_mw[estimate]);
      add_cell(out, estimates.loss_sigma_mw[estimate]);
      add_cell(out, estimates.trusted[estimate] != 0 ? 1 : 0);
      add_cell(out, static_cast<float>(record::loss_instant_s(
                        estimates, estimate, static_cast<double>(run.sample_rate_hz))));
      ++estimate;
    } else {
      out.append(kFourEmpty);
    }
    out.push_back('\n');
    if (out.size() > kMostBuffered) {
      sink({out.data(), out.size()});
      out.clear();
    }
  }
  sink({out.data(), out.size()});
}

}  // namespace

void write_csv(const View& view, const Sink& sink) {
  sink(
      "outlet,t_s,true_frequency_hz,frequency_hz,rocof_hz_s,voltage_pu,validity,loss_mw,"
      "loss_sigma_mw,trusted,t_x_s\n");
  for (const std::size_t index : view.outlets) {
    outlet_rows(view.run, view.with_reports(index), sink);
  }
}

std::string csv(const View& view) {
  std::string text;
  write_csv(view, [&](std::string_view part) { text += part; });
  return text;
}

}  // namespace gsbench::render

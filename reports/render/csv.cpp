#include "format.hpp"

#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

// RFC 4180.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char character : text) {
    if (character == '"') cell += '"';
    cell += character;
  }
  return cell + '"';
}

class Row {
 public:
  explicit Row(fmt::memory_buffer& out) : out_(out) {}

  // Shortest digits that read back as the same number; nothing for a number there is not.
  template <class Number>
  void cell(Number value) {
    out_.push_back(',');
    if (!std::isnan(value)) fmt::format_to(std::back_inserter(out_), "{}", value);
  }
  void word(const char* text) { fmt::format_to(std::back_inserter(out_), ",{}", text); }
  void empty(int cells) {
    for (int i = 0; i < cells; ++i) out_.push_back(',');
  }

 private:
  fmt::memory_buffer& out_;
};

const char* validity_word(std::uint8_t validity) {
  constexpr std::array kWords = {"invalid", "valid", "held"};
  return validity < kWords.size() ? kWords[validity] : "unknown";
}

// Reports and estimates are merged by tick: an estimate that came between two reports has a row of
// its own.
void outlet_rows(const record::RunRecord& run, const record::OutletRecord& outlet,
                 fmt::memory_buffer& out) {
  const std::string id = quoted(outlet.id);
  const record::MeasurementTrace& trace = outlet.trace;
  const record::EstimateTrace& estimates = outlet.estimates;
  std::size_t report = 0;
  std::size_t estimate = 0;
  while (report < trace.tick.size() || estimate < estimates.tick.size()) {
    const bool reports_left = report < trace.tick.size();
    const bool estimates_left = estimate < estimates.tick.size();
    const bool has_report =
        reports_left && (!estimates_left || trace.tick[report] <= estimates.tick[estimate]);
    const bool has_estimate =
        estimates_left && (!reports_left || estimates.tick[estimate] <= trace.tick[report]);
    const std::int64_t tick = has_report ? trace.tick[report] : estimates.tick[estimate];

    out.append(id);
    Row row(out);
    row.cell(seconds(run, tick));
    row.cell(record::frequency_hz(run.truth, tick));
    if (has_report) {
      row.cell(trace.frequency_hz[report]);
      row.cell(trace.rocof_hz_s[report]);
      row.cell(trace.voltage_pu[report]);
      row.word(validity_word(trace.validity[report]));
      ++report;
    } else {
      row.empty(4);
    }
    if (has_estimate) {
      row.cell(estimates.loss_mw[estimate]);
      row.cell(estimates.loss_sigma_mw[estimate]);
      row.word(estimates.trusted[estimate] != 0 ? "1" : "0");
      row.cell(estimates.t_x_s[estimate]);
      ++estimate;
    } else {
      row.empty(4);
    }
    out.push_back('\n');
  }
}

}  // namespace

std::string csv(const record::RunRecord& run) {
  fmt::memory_buffer out;
  out.append(
      std::string("outlet,t_s,true_frequency_hz,frequency_hz,rocof_hz_s,voltage_pu,validity,loss_"
                  "mw,loss_sigma_mw,trusted,t_x_s\n"));
  for (const record::OutletRecord& outlet : run.outlets) outlet_rows(run, outlet, out);
  return fmt::to_string(out);
}

}  // namespace gsbench::render

#include "format.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

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

// The rows of one outlet. Reports and estimates are merged by tick: an estimate between two reports
// has a row of its own.
class OutletRows {
 public:
  OutletRows(const record::RunRecord& run, const std::string& id, const Sink& sink)
      : run_(run), id_(quoted(id)), sink_(sink) {}

  // Each piece waits for the next, in which estimates for its reports may come.
  void add(const record::Reports& piece) {
    const std::int64_t last_tick = waiting_.trace.tick.empty() ? -1 : waiting_.trace.tick.back();
    waiting_.append(piece);
    write_until(last_tick);
  }
  void finish() { write_until(kNone - 1); }

 private:
  static constexpr auto kNone = std::numeric_limits<std::int64_t>::max();
  static constexpr std::size_t kMostBuffered = 1U << 16U;

  static std::int64_t tick_at(const std::vector<std::int64_t>& ticks, std::size_t i) {
    return i < ticks.size() ? ticks[i] : kNone;
  }

  void write_until(std::int64_t last_tick) {
    const record::MeasurementTrace& trace = waiting_.trace;
    const record::EstimateTrace& estimates = waiting_.estimates;
    std::size_t report = 0;
    std::size_t estimate = 0;
    for (;;) {
      const std::int64_t report_tick = tick_at(trace.tick, report);
      const std::int64_t estimate_tick = tick_at(estimates.tick, estimate);
      const std::int64_t tick = std::min(report_tick, estimate_tick);
      if (tick > last_tick) {
        break;
      }
      out_.append(id_);
      add_cell(out_, seconds(run_, tick));
      add_cell(out_, record::frequency_hz(run_.reference, tick));
      if (report_tick == tick) {
        write_report(report++);
      } else {
        out_.append(kFourEmpty);
      }
      if (estimate_tick == tick) {
        write_estimate(estimate++);
      } else {
        out_.append(kFourEmpty);
      }
      out_.push_back('\n');
      if (out_.size() > kMostBuffered) {
        flush();
      }
    }
    flush();
    record::Reports rest;
    for (; report < trace.tick.size(); ++report) {
      record::append(trace, report, rest.trace);
    }
    for (; estimate < estimates.tick.size(); ++estimate) {
      record::append(estimates, estimate, rest.estimates);
    }
    waiting_ = std::move(rest);
  }

  void write_report(std::size_t i) {
    const record::MeasurementTrace& trace = waiting_.trace;
    add_cell(out_, trace.frequency_hz[i]);
    add_cell(out_, trace.rocof_hz_s[i]);
    add_cell(out_, trace.voltage_pu[i]);
    fmt::format_to(std::back_inserter(out_), ",{}", validity_word(trace.validity[i]));
  }

  void write_estimate(std::size_t i) {
    const record::EstimateTrace& estimates = waiting_.estimates;
    add_cell(out_, estimates.loss_mw[i]);
    add_cell(out_, estimates.loss_sigma_mw[i]);
    add_cell(out_, estimates.trusted[i] != 0 ? 1 : 0);
    add_cell(out_, static_cast<float>(record::loss_instant_s(
                       estimates, i, static_cast<double>(run_.sample_rate_hz))));
  }

  void flush() {
    sink_({out_.data(), out_.size()});
    out_.clear();
  }

  const record::RunRecord& run_;
  std::string id_;
  const Sink& sink_;
  record::Reports waiting_;  // only its traces
  fmt::memory_buffer out_;
};

}  // namespace

void write_csv(const View& view, const Sink& sink) {
  sink(
      "outlet,t_s,true_frequency_hz,frequency_hz,rocof_hz_s,voltage_pu,validity,loss_mw,"
      "loss_sigma_mw,trusted,t_x_s\n");
  for (const std::size_t index : view.outlets) {
    OutletRows rows(view.run, view.run.outlets[index].id, sink);
    view.read_reports(index, [&](const record::Reports& piece) { rows.add(piece); });
    rows.finish();
  }
}

std::string csv(const View& view) {
  std::string text;
  write_csv(view, [&](std::string_view part) { text += part; });
  return text;
}

}  // namespace gsbench::render

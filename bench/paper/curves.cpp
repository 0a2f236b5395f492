// Sections that follow from the grid alone.
#include "sections.hpp"
#include <control_centre/threshold.hpp>

#include <fmt/format.h>

#include <grid/falling_limb.hpp>
#include <grid/sfr_model.hpp>

namespace gsbench::paper {
namespace {

using record::kNoFigure;

constexpr double kStep_s = 0.02;
constexpr int kSteps = 1000;

}  // namespace

PageSection fig8_and_13(Study& study, const Execution& /*execution*/) {
  const grid::Grid& grid = study.grid;
  const grid::SfrModel model(grid);
  const double threshold_mw = control_centre::threshold_mw(model, grid.threshold_hz);
  const grid::Nadir lowest = grid::nadir(model, threshold_mw);
  const record::FigureTable table = {
      "The threshold loss: the largest after which no load has to be shed",
      "",
      {{"paper"}, {"gsbench"}},
      {{"threshold loss, MW", {grid.reference.threshold_mw.value_or(kNoFigure), threshold_mw}, 1},
       {"time of its nadir, s", {grid.reference.t_nadir_s.value_or(kNoFigure), lowest.t_s}, 2},
       {"its nadir, Hz", {kNoFigure, lowest.frequency_hz}, 3}}};
  record::CurvePlot plot = {"The frequency after the threshold loss and after 500 MW.", "s", "Hz"};
  record::Curve at_threshold{"threshold loss", {}};
  record::Curve at_500{"500 MW", {}};
  for (int step = 0; step <= kSteps; ++step) {
    const double t_s = kStep_s * step;
    plot.x.push_back(t_s);
    at_threshold.y.push_back(grid.nominal_hz + threshold_mw * model.unit_deviation_hz(t_s));
    at_500.y.push_back(grid.nominal_hz + 500.0 * model.unit_deviation_hz(t_s));
  }
  plot.curves = {at_threshold, at_500};
  std::vector<std::string> notes;
  if (!grid.reference.note.empty()) {
    notes.push_back(grid.reference.note);
  }
  return {{table}, {plot}, notes};
}

PageSection fig9_and_table1(Study& study, const Execution& /*execution*/) {
  const grid::Grid& grid = study.grid;
  const grid::SfrModel model(grid);
  record::FigureTable table = {"ROCOF below which the condition is met, Hz/s",
                               "from … to, Hz",
                               {{"paper", 4}, {"gsbench", 4}, {"difference", 4}},
                               {}};
  const auto rows = control_centre::conditions(model, grid.threshold_hz, grid.condition_row_hz);
  const std::vector<double>& printed = grid.reference.condition_rocof_hz_s;
  record::CurvePlot plot = {"The conditions that an outlet is sent.", "Hz", "Hz/s"};
  plot.steps = true;
  record::Curve limits{"ROCOF limit", {}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double paper = i < printed.size() ? printed[i] : kNoFigure;
    table.rows.push_back({fmt::format("{:.2f} … {:.2f}", rows[i].from_hz, rows[i].to_hz),
                          {paper, rows[i].rocof_below_hz_s, rows[i].rocof_below_hz_s - paper}});
  }
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    plot.x.push_back(row->from_hz);
    limits.y.push_back(row->rocof_below_hz_s);
  }
  plot.curves = {limits};
  return {{table}, {plot}, {"As in Table 1, a row has the ROCOF at its lower edge."}};
}

PageSection fig14(Study& study, const Execution& /*execution*/) {
  const grid::Grid& grid = study.grid;
  const grid::SfrModel model(grid);
  const double threshold_mw = control_centre::threshold_mw(model, grid.threshold_hz);
  record::CurvePlot plot = {
      "ROCOF against the frequency deviation, up to the nadir. The larger the loss, the lower the "
      "ROCOF at any frequency.",
      "Hz below nominal", "Hz/s"};
  constexpr double kStep_hz = 0.005;
  constexpr int kStepsBelow = 180;
  for (int step = 0; step < kStepsBelow; ++step) {
    plot.x.push_back(kStep_hz * step);
  }
  for (const double loss_mw : {100.0, 200.0, 300.0, threshold_mw, 400.0, 500.0, 600.0}) {
    record::Curve curve{fmt::format("{:.1f} MW", loss_mw), {}};
    const double nadir_s = grid::nadir(model, loss_mw).t_s;
    double t_s = 0.0;
    for (const double below_hz : plot.x) {
      while (t_s < nadir_s && -loss_mw * model.unit_deviation_hz(t_s) < below_hz) {
        t_s += 0.001;
      }
      curve.y.push_back(t_s < nadir_s ? loss_mw * model.unit_rocof_hz_s(t_s) : kNoFigure);
    }
    plot.curves.push_back(curve);
  }
  return {{}, {plot}, {}};
}

}  // namespace gsbench::paper

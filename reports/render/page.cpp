#include "format.hpp"
#include "html_elements.hpp"
#include "json_text.hpp"
#include "templates.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <render/page.hpp>

namespace gsbench::render {
namespace {

using record::FigureRow;
using record::FigureTable;

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// Frequencies to a millihertz, whatever their column or row names after its comma; all else to six
// digits.
std::string text_of(const FigureTable& table, const FigureRow& row, std::size_t column) {
  const double value = row.figures[column];
  const bool in_hz = table.unit == "Hz" || ends_with(row.name, ", Hz") ||
                     (column < table.columns.size() && ends_with(table.columns[column], ", Hz"));
  return in_hz && std::isfinite(value) ? fmt::format("{:.3f}", value) : figure(value, 6);
}

Json table_json(const FigureTable& table) {
  const auto row_json = [](const FigureRow& row) {
    return Json{{"name", row.name}, {"figures", row.figures}};
  };
  return {{"caption", table.caption},
          {"columns", table.columns},
          {"rows", array_of(table.rows, row_json)}};
}

Json plot_json(const record::CurvePlot& plot) {
  const auto curve_json = [](const record::Curve& curve) {
    return Json{{"name", curve.name}, {"y", curve.y}};
  };
  return {{"caption", plot.caption},
          {"x_axis", plot.x_axis},
          {"y_axis", plot.y_axis},
          {"steps", plot.steps},
          {"x", plot.x},
          {"curves", array_of(plot.curves, curve_json)}};
}

Json section_json(const record::PageSection& section) {
  return {{"id", section.id},
          {"title", section.title},
          {"paragraphs", section.paragraphs},
          {"tables", array_of(section.tables, table_json)},
          {"plots", array_of(section.plots, plot_json)}};
}

// The lowest of a heat map is blue, the highest red.
std::string heat_of(const FigureTable& table, double figure) {
  double low = record::kNoFigure;
  double high = record::kNoFigure;
  for (const FigureRow& row : table.rows) {
    for (const double each : row.figures) {
      low = std::fmin(low, each);
      high = std::fmax(high, each);
    }
  }
  if (!table.heat || !std::isfinite(figure) || !(high > low)) {
    return {};
  }
  const double part = (figure - low) / (high - low);
  return fmt::format("background: hsl({:.0f} 70% 50% / 0.45)", 220.0 + 140.0 * part);
}

object table_data(const FigureTable& table) {
  List rows;
  for (const FigureRow& row : table.rows) {
    List cells;
    for (std::size_t i = 0; i < row.figures.size(); ++i) {
      cells.push_back(
          object{{"figure", text_of(table, row, i)}, {"style", heat_of(table, row.figures[i])}});
    }
    rows.push_back(object{{"name", row.name}, {"cells", cells}});
  }
  return {{"caption", table.caption},
          {"first", table.first_column},
          {"columns", List(table.columns.begin(), table.columns.end())},
          {"rows", rows}};
}

void append_table(const FigureTable& table, std::string& text) {
  std::vector<std::vector<std::string>> rows(1, {table.first_column});
  rows[0].insert(rows[0].end(), table.columns.begin(), table.columns.end());
  for (const FigureRow& row : table.rows) {
    rows.push_back({row.name});
    for (std::size_t i = 0; i < row.figures.size() && i < table.columns.size(); ++i) {
      rows.back().push_back(text_of(table, row, i));
    }
  }
  text += "  " + table.caption + "\n";
  for (const std::string& line : aligned(rows)) {
    text += "  " + line + "\n";
  }
}

}  // namespace

std::string json(const record::Page& page) {
  Json facts = Json::object();
  for (const auto& [name, value] : page.facts) {
    facts[name] = value;
  }
  return indented({{"title", page.title},
                   {"facts", facts},
                   {"sections", array_of(page.sections, section_json)}});
}

std::string terminal(const record::Page& page) {
  std::string text = page.title + "\n";
  for (const auto& [name, value] : page.facts) {
    text += fmt::format("  {}: {}\n", name, value);
  }
  for (const record::PageSection& section : page.sections) {
    text += "\n" + section.title + "\n";
    for (const FigureTable& table : section.tables) {
      append_table(table, text);
    }
    for (const std::string& paragraph : section.paragraphs) {
      text += "  " + paragraph + "\n";
    }
  }
  return text;
}

std::string html(const record::Page& page) {
  List facts;
  for (const auto& [name, value] : page.facts) {
    facts.push_back(object{{"name", name}, {"value", value}});
  }
  List sections;
  Json plots = Json::array();
  for (const record::PageSection& section : page.sections) {
    List tables;
    for (const FigureTable& table : section.tables) {
      tables.push_back(table_data(table));
    }
    List plot_places;
    for (const record::CurvePlot& plot : section.plots) {
      plot_places.push_back(
          object{{"number", std::to_string(plots.size())}, {"caption", plot.caption}});
      plots.push_back(plot_json(plot));
    }
    sections.push_back(
        object{{"id", section.id},
               {"heading", section.title},
               {"paragraphs", List(section.paragraphs.begin(), section.paragraphs.end())},
               {"tables", tables},
               {"plots", plot_places}});
  }
  const object all = {{"title", page.title},
                      {"subtitle", page.subtitle},
                      {"facts", facts},
                      {"sections", sections},
                      {"plots_json", in_script(plots)},
                      {"page_js", std::string(templates::page_js)}};
  return filled(templates::page_html, all);
}

}  // namespace gsbench::render

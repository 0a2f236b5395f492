#include "format.hpp"
#include "templates.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include <render/page.hpp>

namespace gsbench::render {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::object;
using List = kainjow::mustache::list;
using nlohmann::ordered_json;
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

ordered_json number_or_null(double figure) {
  return std::isfinite(figure) ? ordered_json(figure) : ordered_json();
}

ordered_json numbers(const std::vector<double>& figures) {
  ordered_json all = ordered_json::array();
  for (const double figure : figures) {
    all.push_back(number_or_null(figure));
  }
  return all;
}

ordered_json as_json(const FigureTable& table) {
  ordered_json rows = ordered_json::array();
  for (const FigureRow& row : table.rows) {
    rows.push_back({{"name", row.name}, {"figures", numbers(row.figures)}});
  }
  return {{"caption", table.caption}, {"columns", table.columns}, {"rows", rows}};
}

ordered_json as_json(const record::CurvePlot& plot) {
  ordered_json curves = ordered_json::array();
  for (const record::Curve& curve : plot.curves) {
    curves.push_back({{"name", curve.name}, {"y", numbers(curve.y)}});
  }
  return {{"caption", plot.caption}, {"x_axis", plot.x_axis}, {"y_axis", plot.y_axis},
          {"steps", plot.steps},     {"x", numbers(plot.x)},  {"curves", curves}};
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
  List columns;
  for (const std::string& column : table.columns) {
    columns.push_back(object{{"column", column}});
  }
  List rows;
  for (const FigureRow& row : table.rows) {
    List cells;
    for (std::size_t i = 0; i < row.figures.size(); ++i) {
      cells.push_back(
          object{{"figure", text_of(table, row, i)}, {"style", heat_of(table, row.figures[i])}});
    }
    rows.push_back(object{{"name", row.name}, {"cells", data(cells)}});
  }
  return {{"caption", table.caption},
          {"first", table.first_column},
          {"columns", data(columns)},
          {"rows", data(rows)}};
}

std::size_t letters(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string space(width - std::min(width, letters(text)), ' ');
  return right ? space + text : text + space;
}

void append_table(const FigureTable& table, std::string& text) {
  std::size_t first = letters(table.first_column);
  std::vector<std::size_t> widths;
  for (const std::string& column : table.columns) {
    widths.push_back(letters(column));
  }
  for (const FigureRow& row : table.rows) {
    first = std::max(first, letters(row.name));
    for (std::size_t i = 0; i < row.figures.size() && i < widths.size(); ++i) {
      widths[i] = std::max(widths[i], letters(text_of(table, row, i)));
    }
  }
  text += "  " + table.caption + "\n  " + padded(table.first_column, first, false);
  for (std::size_t i = 0; i < widths.size(); ++i) {
    text += "  " + padded(table.columns[i], widths[i], true);
  }
  for (const FigureRow& row : table.rows) {
    text += "\n  " + padded(row.name, first, false);
    for (std::size_t i = 0; i < row.figures.size() && i < widths.size(); ++i) {
      text += "  " + padded(text_of(table, row, i), widths[i], true);
    }
  }
  text += "\n";
}

}  // namespace

std::string json(const record::Page& page) {
  ordered_json facts = ordered_json::object();
  for (const auto& [name, value] : page.facts) {
    facts[name] = value;
  }
  ordered_json sections = ordered_json::array();
  for (const record::PageSection& section : page.sections) {
    ordered_json tables = ordered_json::array();
    for (const FigureTable& table : section.tables) {
      tables.push_back(as_json(table));
    }
    ordered_json plots = ordered_json::array();
    for (const record::CurvePlot& plot : section.plots) {
      plots.push_back(as_json(plot));
    }
    sections.push_back({{"id", section.id},
                        {"title", section.title},
                        {"paragraphs", section.paragraphs},
                        {"tables", tables},
                        {"plots", plots}});
  }
  return ordered_json{{"title", page.title}, {"facts", facts}, {"sections", sections}}.dump(2) +
         "\n";
}

std::string terminal(const record::Page& page) {
  std::string text = page.title + "\n";
  for (const auto& [name, value] : page.facts) {
    text += "  ";
    text += name;
    text += ": ";
    text += value;
    text += '\n';
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
  ordered_json plots = ordered_json::array();
  for (const record::PageSection& section : page.sections) {
    List paragraphs;
    for (const std::string& paragraph : section.paragraphs) {
      paragraphs.push_back(object{{"paragraph", paragraph}});
    }
    List tables;
    for (const FigureTable& table : section.tables) {
      tables.push_back(table_data(table));
    }
    List plot_places;
    for (const record::CurvePlot& plot : section.plots) {
      plot_places.push_back(
          object{{"number", std::to_string(plots.size())}, {"caption", plot.caption}});
      plots.push_back(as_json(plot));
    }
    sections.push_back(object{{"id", section.id},
                              {"heading", section.title},
                              {"paragraphs", data(paragraphs)},
                              {"tables", data(tables)},
                              {"plots", data(plot_places)}});
  }
  // Within a script element nothing may end it.
  std::string plot_text = plots.dump();
  for (std::size_t at = plot_text.find('<'); at != std::string::npos; at = plot_text.find('<')) {
    plot_text.replace(at, 1, "\\u003c");
  }
  const object all = {{"title", page.title},
                      {"subtitle", page.subtitle},
                      {"facts", data(facts)},
                      {"sections", data(sections)},
                      {"plots_json", plot_text},
                      {"dygraphs_js", std::string(templates::dygraphs_js)},
                      {"dygraphs_css", std::string(templates::dygraphs_css)},
                      {"dygraphs_licence", std::string(templates::dygraphs_licence)},
                      {"report_css", std::string(templates::report_css)},
                      {"page_js", std::string(templates::page_js)}};
  kainjow::mustache::mustache page_template{std::string(templates::page_html)};
  return page_template.render(all);
}

}  // namespace gsbench::render

#include "format.hpp"
#include "html_elements.hpp"
#include "json_text.hpp"
#include "templates.hpp"
#include "text_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <record/run_record.hpp>
#include <render/page.hpp>

namespace gsbench::render {
namespace {

using record::FigureRow;
using record::FigureTable;

constexpr int kPageFormatVersion = 1;  // of json(); see reports/README.md
constexpr std::size_t kIndent = 2;     // of text below a heading
constexpr std::size_t kHanging = 4;    // of its continuation lines

std::string text_of(const FigureTable& table, const FigureRow& row, std::size_t i) {
  const double value = row.figures[i];
  const record::FigureColumn& column = table.columns[i];
  if (value < column.least || value > column.most) {
    return "none";
  }
  return fixed(value, row.decimals.value_or(column.decimals));
}

std::vector<std::string> names_of(const FigureTable& table) {
  std::vector<std::string> names;
  for (const record::FigureColumn& column : table.columns) {
    names.push_back(column.name);
  }
  return names;
}

std::string verdict_of(const record::Judgement& judgement) {
  if (!judgement.passed) {
    return fixed(record::kNoFigure, 0);
  }
  return to_string(*judgement.passed ? record::Verdict::kPass : record::Verdict::kFail);
}

bool is_judged(const FigureTable& table) {
  return !table.rows.empty() && table.rows.front().judgement;
}

void set_judgement(const std::optional<record::Judgement>& judgement, Json& object) {
  if (judgement) {
    object["verdict"] = judgement->passed ? Json(verdict_of(*judgement)) : Json();
    object["reasons"] = judgement->reasons;
  }
}

Json table_json(const FigureTable& table) {
  const auto row_json = [](const FigureRow& row) {
    return Json{{"name", row.name}, {"figures", row.figures}};
  };
  return {{"caption", table.caption},
          {"columns", names_of(table)},
          {"rows", array_of(table.rows, row_json)}};
}

Json list_json(const FigureTable& table) {
  const auto row_json = [&](const FigureRow& row) {
    Json object = {{table.row_key, table.row_prefix + row.name}};
    set_judgement(row.judgement, object);
    for (std::size_t i = 0; i < row.figures.size() && i < table.columns.size(); ++i) {
      const record::FigureColumn& column = table.columns[i];
      const double figure = row.figures[i];
      if (!column.key.empty()) {
        object[column.key] = column.decimals == 0 && std::isfinite(figure)
                                 ? Json(static_cast<std::int64_t>(std::llround(figure)))
                                 : Json(figure);
      }
    }
    for (const FigureTable& list : row.lists) {
      object[list.list] = list_json(list);
    }
    return object;
  };
  return array_of(table.rows, row_json);
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

// From blue for the lowest figure of the table to red for the highest.
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
  for (const std::string& name : names_of(table)) {
    columns.push_back(name);
  }
  if (is_judged(table)) {
    columns.push_back("");
  }
  List rows;
  for (const FigureRow& row : table.rows) {
    List cells;
    for (std::size_t i = 0; i < row.figures.size() && i < table.columns.size(); ++i) {
      cells.push_back(object{{"figure", text_of(table, row, i)},
                             {"class", ""},
                             {"style", heat_of(table, row.figures[i])}});
    }
    if (row.judgement) {
      cells.push_back(object{{"figure", verdict_of(*row.judgement)},
                             {"class", row.judgement->passed == false ? "missed" : ""},
                             {"style", ""}});
    }
    rows.push_back(object{{"name", row.name}, {"cells", cells}});
  }
  return {{"caption", table.caption},
          {"first", table.first_column},
          {"columns", columns},
          {"rows", rows}};
}

void append_wrapped(const std::string& paragraph, std::string& text) {
  text += wrapped(std::string(kIndent, ' ') + paragraph, kLineColumns, kHanging) + '\n';
}

void append_table(const FigureTable& table, std::string& text) {
  std::vector<std::vector<std::string>> rows(1, names_of(table));
  rows[0].insert(rows[0].begin(), table.first_column);
  if (is_judged(table)) {
    rows[0].emplace_back();
  }
  for (const FigureRow& row : table.rows) {
    rows.push_back({row.name});
    for (std::size_t i = 0; i < row.figures.size() && i < table.columns.size(); ++i) {
      rows.back().push_back(text_of(table, row, i));
    }
    if (row.judgement) {
      rows.back().push_back(verdict_of(*row.judgement));
    }
  }
  append_wrapped(table.caption, text);
  for (const std::string& line : table_lines(rows, kLineColumns - kIndent)) {
    text += std::string(kIndent, ' ') + line + '\n';
  }
}

}  // namespace

std::string json(const record::Page& page) {
  Json facts = Json::object();
  for (const auto& [name, value] : page.facts) {
    facts[name] = value;
  }
  Json all = {{"format_version", kPageFormatVersion}, {"title", page.title}, {"facts", facts}};
  set_judgement(page.judgement, all);
  for (const record::PageSection& section : page.sections) {
    for (const FigureTable& table : section.tables) {
      if (!table.list.empty()) {
        all[table.list] = list_json(table);
      }
    }
  }
  all["sections"] = array_of(page.sections, section_json);
  return indented(all);
}

std::string terminal(const record::Page& page) {
  std::string text = wrapped(page.title, kLineColumns, kIndent) + '\n';
  if (!page.subtitle.empty()) {
    append_wrapped(page.subtitle, text);
  }
  for (const auto& [name, value] : page.facts) {
    append_wrapped(fmt::format("{}: {}", name, value), text);
  }
  for (const record::PageSection& section : page.sections) {
    text += '\n' + wrapped(section.title, kLineColumns, kIndent) + '\n';
    for (const FigureTable& table : section.tables) {
      text += &table == &section.tables.front() ? "" : "\n";
      append_table(table, text);
    }
    text += section.tables.empty() || section.paragraphs.empty() ? "" : "\n";
    for (const std::string& paragraph : section.paragraphs) {
      append_wrapped(paragraph, text);
    }
    if (section.tables.empty() && !section.plots.empty()) {
      append_wrapped("Curves only: they are in the HTML report.", text);
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

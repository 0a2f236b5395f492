// A page of tables, curves and notes, independent of how it was computed and how it is printed.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gsbench::record {

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();  // an empty cell

struct FigureColumn {
  std::string name;
  int decimals = 0;  // printed; JSON has every figure in full
  // A figure outside least … most is printed as "none".
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  std::string key = {};  // of the figures in FigureTable::list
};

// Whether limits are met.
struct Judgement {
  std::optional<bool> passed;        // nothing: not judged
  std::vector<std::string> reasons;  // why not passed, or not judged
};

// "PASS", or "FAIL: " or "not judged: " with the reasons.
std::string to_string(const Judgement& judgement);

struct FigureTable;

struct FigureRow {
  std::string name;
  std::vector<double> figures;       // one for each column; kNoFigure: an empty cell
  std::optional<int> decimals = {};  // instead of the columns', for a row with its own unit
  // PASS, FAIL or an empty cell after the figures. Either all rows of a table have one, or none.
  std::optional<Judgement> judgement = {};
  std::vector<FigureTable> lists = {};  // more lists of the row's object in FigureTable::list
};

struct FigureTable {
  std::string caption;
  std::string first_column;  // heading of the row names
  std::vector<FigureColumn> columns;
  std::vector<FigureRow> rows = {};
  bool heat = false;  // the HTML page colours each cell by its figure
  // For scripts: if not empty, JSON also has the table as a list with this key, of an object for
  // each row: the row's name, by row_key; its verdict and reasons; its figures by the keys of their
  // columns, without those that have none; its lists. Figures without decimals are integers there.
  std::string list = {};
  std::string row_key = {};
  std::string row_prefix = {};  // the beginning of all names, which only the list has
};

struct Curve {
  std::string name;
  std::vector<double> y;  // one for each x; kNoFigure: a gap
};

struct CurvePlot {
  std::string caption;
  std::string x_axis;
  std::string y_axis;
  std::vector<double> x = {};  // rising
  std::vector<Curve> curves = {};
  bool steps = false;  // each y holds until the next x
};

struct PageSection {
  std::vector<FigureTable> tables;
  std::vector<CurvePlot> plots;
  std::vector<std::string> paragraphs;
  std::string title = {};
  std::string id = {};  // the name by which a command selects the section: "table4"
};

struct Page {
  std::string title;
  std::string subtitle;
  std::vector<std::pair<std::string, std::string>> facts;
  std::vector<PageSection> sections;
  std::optional<Judgement> judgement = {};  // of all; JSON has it as verdict and reasons
};

}  // namespace gsbench::record

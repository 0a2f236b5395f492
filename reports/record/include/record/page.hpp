// What a page of figures and curves holds, whoever worked them out and whatever it is printed as.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace gsbench::record {

constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();  // an empty cell

struct FigureRow {
  std::string name;
  std::vector<double> figures;  // one a column; kNoFigure: empty
};

struct FigureTable {
  std::string caption;
  std::string first_column;  // what its rows are
  std::vector<std::string> columns;
  std::vector<FigureRow> rows = {};
  bool heat = false;      // coloured by size
  std::string unit = {};  // of every figure, where neither columns nor rows name theirs
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
  std::string id = {};  // by which it is asked for: "table4"
};

struct Page {
  std::string title;
  std::string subtitle;
  std::vector<std::pair<std::string, std::string>> facts;
  std::vector<PageSection> sections;
};

}  // namespace gsbench::record

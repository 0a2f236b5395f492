// Numbers and texts as people read them. Machines get theirs in full from json() and csv().
#pragma once

#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

// `significant` digits, no trailing zeros; "–" for NaN.
std::string figure(double value, int significant = 5);

// As many decimals as two significant digits of the uncertainty need; where there is none, as
// figure() has it.
std::string figure_within(double value, double uncertainty);

// That many decimals, 0 … 9; "–" for NaN.
std::string fixed(double value, int decimals);

std::string with_unit(const std::string& text, const std::string& unit);

// "≤ 160 ms", "-4 … 4 %", "open"; empty where nothing was asked.
std::string limits(const record::MeasurementResult& result);

// The word, or the number with its unit and uncertainty: "112.00 ± 0.13 ms".
std::string value_of(const record::MeasurementResult& result);

// Seconds on the run's time base; NaN for a record without sample rate.
double seconds(const record::RunRecord& run, std::int64_t tick);

// What may stand in XML, HTML and on a terminal: bytes that are no UTF-8 and control characters but
// tab and line end become U+FFFD.
std::string valid_text(const std::string& text);

// Columns on a terminal. A code point is one: nothing wider is printed.
std::size_t columns_of(const std::string& text);

// `text` broken at spaces into lines of at most `columns`, without a line end after the last. All
// lines but the first start with `indent` spaces. A word longer than a line is not broken; line
// ends in `text` are kept.
std::string wrapped(const std::string& text, std::size_t columns, std::size_t indent = 0);

// A line for each row: the first cell aligned left, the others right, two spaces between. Rows may
// differ in length.
std::vector<std::string> aligned(const std::vector<std::vector<std::string>>& rows);

}  // namespace gsbench::render

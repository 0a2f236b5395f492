// Texts of reports as people read them.
#pragma once

#include <string>
#include <vector>

#include <record/run_record.hpp>
#include <render/figures.hpp>
#include <render/layout.hpp>

namespace gsbench::render {

std::string with_unit(const std::string& text, const std::string& unit);

// "≤ 160 ms", "-4 … 4 %", "open"; empty if the result has no limit.
std::string limits(const record::MeasurementResult& result);

// The text value, or the number with unit and uncertainty: "112.00 ± 0.13 ms". A value outside its
// limits is never rounded onto them.
std::string value_of(const record::MeasurementResult& result);

// Time on the run's time base, s; NaN for a record without a sample rate.
double seconds(const record::RunRecord& run, std::int64_t tick);

// Text that XML, HTML and terminals can take: bytes that are not UTF-8 and control characters
// except tab and line end become U+FFFD.
std::string valid_text(const std::string& text);

}  // namespace gsbench::render

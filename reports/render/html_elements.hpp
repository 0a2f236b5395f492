// Elements that all HTML reports share.
#pragma once

#include "key_figures.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <kainjow/mustache.hpp>

#include <record/run_record.hpp>

namespace gsbench::render {

using kainjow::mustache::object;
using List = kainjow::mustache::list;

// The template filled with `values`, the style sheet and the plotting library.
std::string filled(std::string_view page_template, object values);

// `value` for a section of a template. A text cannot be the flag: a section takes even an empty
// text as true.
kainjow::mustache::data flag(bool value);

// "verdict", "class" (of CSS) and "sign".
void set_verdict(object& where, record::Verdict verdict);

// An outlet's part of a report: its row of key figures and its tables.
object outlet_object(const record::RunRecord& run, std::size_t index,
                     const std::vector<KeyColumn>& columns);

// `text` with U+2212 as the minus sign of numbers; only for texts that this program formats.
std::string typographic(std::string text);

}  // namespace gsbench::render

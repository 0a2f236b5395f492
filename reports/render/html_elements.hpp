// Elements that all HTML reports share.
#pragma once

#include "key_figures.hpp"

#include <cstddef>
#include <functional>
#include <optional>
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

// A report stays below 5 MB whatever the record contains: each of its parts has a limit of its own,
// in bytes of HTML.
constexpr std::size_t kMostText = 600;  // of one text

// `text` as valid_text(), with "…" in place of its end if it takes more than `most` bytes in HTML.
std::string clipped(const std::string& text, std::size_t most = kMostText);

// The first of `count` rows that make() makes, as many as fit into `most` bytes. A row takes
// `markup` bytes for each of its objects, and its texts.
List rows_within(std::size_t most, std::size_t markup, std::size_t count,
                 const std::function<object(std::size_t)>& make);

// A row of key figures. `drawn`: the outlet's place among those that are shown in full.
object overview_row(const record::OutletRecord& outlet, const std::vector<KeyColumn>& columns,
                    std::size_t row, std::optional<std::size_t> drawn);

// All of an outlet but its curves, in at most `most` bytes.
object outlet_object(const record::RunRecord& run, const record::OutletRecord& outlet,
                     std::size_t drawn, std::size_t most);

// `text` with U+2212 as the minus sign of numbers; only for texts that this program formats.
std::string typographic(std::string text);

}  // namespace gsbench::render

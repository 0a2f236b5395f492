// What the parts of an HTML report have in common.
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

// The page of a template, with these values, style sheet and plotting library.
std::string filled(std::string_view page_template, object values);

// A template's section takes an empty text for true; a flag is what it says.
kainjow::mustache::data flag(bool value);

// "verdict", "class" (of CSS) and "sign".
void set_verdict(object& where, record::Verdict verdict);

// An outlet's part of a report: its row of key figures and its tables.
object outlet_object(const record::RunRecord& run, std::size_t index,
                     const std::vector<KeyFigure>& keys);

// With a page's typographic minus; only what was formatted here passes through.
std::string typographic(std::string text);

}  // namespace gsbench::render

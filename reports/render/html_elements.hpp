// What the parts of an HTML report have in common.
#pragma once

#include <string>
#include <string_view>

#include <kainjow/mustache.hpp>

#include <record/run_record.hpp>

namespace gsbench::render {

using kainjow::mustache::object;
using List = kainjow::mustache::list;

// The page of a template, with these values. Compiled once: the template's reader is a header.
std::string filled(std::string_view page_template, const object& values);

// A template's section takes an empty text for true; a flag is what it says.
kainjow::mustache::data flag(bool value);

// "verdict", "class" (of CSS) and "sign".
void set_verdict(object& where, record::Verdict verdict);

// With a page's typographic minus; only what was formatted here passes through.
std::string typographic(std::string text);

}  // namespace gsbench::render

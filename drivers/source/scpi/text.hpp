// Commands from templates, and values from answers.
#pragma once

#include <source_scpi/instrument.hpp>

#include <string>
#include <utility>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::scpi {

// Placeholder and its text: {"points", "16384"}.
using Values = std::vector<std::pair<std::string, std::string>>;

// Ten digits: settings have fewer.
std::string number_text(double value);

// Replaces each {placeholder}. An unknown one stays.
std::string filled(const std::string& text, const Values& values);

// Names of the placeholders in a template.
std::vector<std::string> placeholders(const std::string& text);

std::vector<std::string> split(const std::string& text, char separator);

// The value at `field` in an answer (Field::field), without blanks and quotes. An error if it is
// missing.
drivers::Result<std::string> value_in(const std::string& answer, const std::string& field);

// A number that may be followed by `unit`, in any case. An error for anything else.
drivers::Result<double> number_in(const std::string& text, const std::string& unit);

bool equal_ignoring_case(const std::string& a, const std::string& b);
// `alternatives`: separated by |.
bool is_one_of(const std::string& text, const std::string& alternatives);

// For messages: unprintable bytes as \xNN, at most 80 characters.
std::string printable(const std::string& text);

}  // namespace gsbench::scpi

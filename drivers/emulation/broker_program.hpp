// Programs that do one thing and end.
#pragma once

#include <string>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::emulation {

// Runs it to its end; an error says what it printed where it did not make `product`.
drivers::Status run_to_make(const std::string& product, const std::vector<std::string>& words,
                            const std::string& log);

std::string text_of(const std::string& file);
drivers::Status write_private(const std::string& file, const std::string& text);

}  // namespace gsbench::emulation

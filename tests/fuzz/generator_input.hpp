// Properties that must hold for any bytes sent to an emulated generator.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gsbench::fuzz {

// The first byte chooses the model, the rest is a stream of messages. Settings stay finite and
// within the limits of the model, and so does the output. Answers end with a newline. Afterwards
// the generator can be reset and identified. Returns what is wrong, or an empty string.
std::string wrong_with_generator(const std::uint8_t* bytes, std::size_t size);
std::vector<std::string> generator_seeds();

}  // namespace gsbench::fuzz

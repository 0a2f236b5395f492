// What a misspelt word was probably meant to be.
#pragma once

#include <string>
#include <vector>

namespace gsbench::keys {

// The end of a message on a word that is none of `known`: `; did you mean "x"?` where one is near,
// else `; <what> are: a, b, c`.
std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const std::string& what);

}  // namespace gsbench::keys

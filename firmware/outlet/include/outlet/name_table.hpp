// Names of enumerators, for messages to people.
#pragma once

#include <cstddef>

namespace gs::outlet {

// `names`: one for each enumerator, in order from 0 to kLast.
template <auto kLast, std::size_t kNames>
const char* name_of(decltype(kLast) value, const char* const (&names)[kNames],
                    const char* of_none = "unknown") {
  static_assert(kNames == static_cast<std::size_t>(kLast) + 1, "a name for each");
  const auto place = static_cast<std::size_t>(value);
  return place < kNames ? names[place] : of_none;
}

}  // namespace gs::outlet

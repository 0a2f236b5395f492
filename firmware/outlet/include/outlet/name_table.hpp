// Names of enumerators, for messages to people.
#pragma once

#include <cstddef>

namespace gs::outlet {

// `names`: one per enumerator, from 0 to kLast. Returns `of_none` for any other value.
template <auto kLast, std::size_t kNames>
const char* name_of(decltype(kLast) value, const char* const (&names)[kNames],
                    const char* of_none = "unknown") {
  static_assert(kNames == static_cast<std::size_t>(kLast) + 1, "one name per enumerator");
  const auto place = static_cast<std::size_t>(value);
  return place < kNames ? names[place] : of_none;
}

}  // namespace gs::outlet

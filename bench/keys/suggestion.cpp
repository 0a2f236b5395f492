#include <algorithm>
#include <cstddef>
#include <numeric>

#include <fmt/format.h>

#include <keys/document.hpp>

namespace gsbench::keys {
namespace {

// Levenshtein distance: insertions, deletions and replacements of one character.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

// "duration" for "duration_s": a forgotten unit is the most likely mistake, but a long distance.
bool is_stem_of(const std::string& name, const std::string& known) {
  return !name.empty() && known.compare(0, name.size(), name) == 0 && known[name.size()] == '_';
}

}  // namespace

std::string suggestion(const std::string& name, const std::vector<std::string>& known,
                       const std::string& what) {
  constexpr std::size_t kLongestName = 100;  // longer ones are not misspellings, and cost time
  const std::string* best = nullptr;
  std::size_t best_distance = std::max<std::size_t>(2, name.size() / 3) + 1;
  for (const std::string& candidate : known) {
    if (name.size() > kLongestName) {
      break;
    }
    const std::size_t d = is_stem_of(name, candidate) ? 1 : distance(name, candidate);
    if (d < best_distance) {
      best_distance = d;
      best = &candidate;
    }
  }
  if (best != nullptr) {
    return fmt::format("; did you mean \"{}\"?", *best);
  }
  if (known.empty()) {
    return fmt::format("; there are no {}", what);
  }
  return fmt::format("; {} are: {}", what, fmt::join(known, ", "));
}

}  // namespace gsbench::keys

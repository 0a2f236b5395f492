#include <algorithm>
#include <cstddef>
#include <numeric>

#include <fmt/format.h>

#include <keys/document.hpp>

namespace gsbench::keys {
namespace {

// Levenshtein's distance: insertions, deletions and replacements of one character.
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

// "duration" for "duration_s": a forgotten unit is the likeliest slip here, and no short distance.
bool is_stem_of(const std::string& word, const std::string& known) {
  return !word.empty() && known.compare(0, word.size(), word) == 0 && known[word.size()] == '_';
}

}  // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const std::string& what) {
  constexpr std::size_t kLongestWord = 100;  // longer ones are no slip, and cost time
  const std::string* best = nullptr;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : known) {
    if (word.size() > kLongestWord) {
      break;
    }
    const std::size_t d = is_stem_of(word, candidate) ? 1 : distance(word, candidate);
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

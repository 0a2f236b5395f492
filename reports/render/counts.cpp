#include "counts.hpp"

#include "format.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numeric>

#include <fmt/format.h>

namespace gsbench::render {
namespace {

using record::Verdict;

struct Counts {
  std::string group;
  std::array<std::size_t, 4> of = {};  // by verdict

  void add(Verdict verdict) { ++of[static_cast<std::size_t>(verdict)]; }
  void add(const Counts& other) {
    std::transform(of.begin(), of.end(), other.of.begin(), of.begin(), std::plus<>());
  }
  std::size_t all() const { return std::accumulate(of.begin(), of.end(), std::size_t{0}); }
  std::size_t missed() const { return all() - of[0]; }
};

// Of each group, that with most outlets that did not pass first.
std::vector<Counts> counts_of_groups(const View& view) {
  std::vector<Counts> groups;
  std::map<std::string, std::size_t> places;
  for (const std::size_t index : view.outlets) {
    const record::OutletRecord& outlet = view.run.outlets[index];
    const auto [place, is_new] = places.insert({outlet.group, groups.size()});
    if (is_new) {
      groups.push_back({shortened(one_line(outlet.group), kMostIdColumns), {}});
    }
    groups[place->second].add(outlet.verdict);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Counts& a, const Counts& b) { return a.missed() > b.missed(); });
  return groups;
}

}  // namespace

std::vector<std::string> count_table(const View& view, std::size_t most_groups) {
  std::vector<Counts> counts = counts_of_groups(view);
  Counts all{"all", {}};
  for (const Counts& group : counts) {
    all.add(group);
  }
  if (counts.size() > most_groups) {
    all.group = fmt::format("all {}", counts.size());
  }
  if (counts.size() > most_groups || counts.size() == 1) {
    counts.clear();
  }
  counts.push_back(all);
  std::vector<std::vector<std::string>> rows = {{"group", "outlets"}};
  for (const Counts& one : counts) {
    rows.push_back({one.group, std::to_string(one.all())});
  }
  for (std::size_t verdict = 0; verdict < all.of.size(); ++verdict) {
    if (all.of[verdict] > 0) {
      rows[0].emplace_back(record::to_string(static_cast<Verdict>(verdict)));
      for (std::size_t i = 0; i < counts.size(); ++i) {
        rows[i + 1].push_back(std::to_string(counts[i].of[verdict]));
      }
    }
  }
  return aligned(rows);
}

std::string one_line(const std::string& text) {
  std::string line = valid_text(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::replace(line.begin(), line.end(), '\t', ' ');
  return line;
}

}  // namespace gsbench::render

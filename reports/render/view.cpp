#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include <render/render.hpp>

namespace gsbench::render {

void Format::write(const View& view, const Sink& sink) const {
  if (write_in_parts != nullptr) {
    write_in_parts(view, sink);
  } else {
    sink(render(view));
  }
}

View::View(const record::RunRecord& shown)
    : run(shown),
      outlets(shown.outlets.size()),
      marked([&shown](std::size_t index) { return shown.outlets[index]; }),
      read_reports([&shown](std::size_t index, const record::TakeReports& take) {
        take(shown.outlets[index].reports);
      }) {
  std::iota(outlets.begin(), outlets.end(), std::size_t{0});
}

std::vector<std::size_t> worst_first(const View& view, std::size_t most) {
  if (view.outlets.size() <= most) {
    return view.outlets;
  }
  std::vector<std::size_t> worst = worst_first(view);
  worst.resize(most);
  return worst;
}

std::vector<std::size_t> worst_first(const View& view) {
  struct Rank {
    record::Verdict verdict;
    std::ptrdiff_t missed;
    std::size_t turn;  // how many of its group are as bad and come before it
    std::size_t index;
  };
  std::vector<Rank> ranks;
  std::map<std::tuple<record::Verdict, std::ptrdiff_t, std::string>, std::size_t> turns;
  for (const std::size_t index : view.outlets) {
    const record::OutletRecord& outlet = view.run.outlets[index];
    const auto missed = std::count_if(
        outlet.measurements.begin(), outlet.measurements.end(), [](const auto& result) {
          return result.judged && result.verdict != record::Verdict::kPass;
        });
    ranks.push_back(
        {outlet.verdict, missed, turns[{outlet.verdict, missed, outlet.group}]++, index});
  }
  std::sort(ranks.begin(), ranks.end(), [](const Rank& a, const Rank& b) {
    return std::tie(b.verdict, b.missed, a.turn, a.index) <
           std::tie(a.verdict, a.missed, b.turn, b.index);
  });
  std::vector<std::size_t> worst;
  worst.reserve(ranks.size());
  for (const Rank& rank : ranks) {
    worst.push_back(rank.index);
  }
  return worst;
}

}  // namespace gsbench::render

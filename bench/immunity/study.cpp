#include <algorithm>
#include <vector>

#include <immunity/study.hpp>

namespace gsbench::immunity {
namespace {

constexpr std::uint32_t kCasesInBlock = 64;

enum Flag : std::uint8_t { kPlayed = 1, kEvent = 2, kTrip = 4 };

void add(const Count& some, Count& sum) {
  sum.cases += some.cases;
  sum.events += some.events;
  sum.trips += some.trips;
}

// The first case of a kind that has `flag`.
std::optional<std::uint32_t> first_with(std::size_t kind, Flag flag,
                                        const std::vector<std::uint8_t>& flags) {
  for (std::size_t number = kind; number < flags.size(); number += kKinds.size()) {
    if ((flags[number] & flag) != 0) {
      return static_cast<std::uint32_t>(number);
    }
  }
  return std::nullopt;
}

Count count(std::size_t kind, const std::vector<std::uint8_t>& flags) {
  Count count;
  for (std::size_t number = kind; number < flags.size(); number += kKinds.size()) {
    count.cases += (flags[number] & kPlayed) != 0 ? 1 : 0;
    count.events += (flags[number] & kEvent) != 0 ? 1 : 0;
    count.trips += (flags[number] & kTrip) != 0 ? 1 : 0;
  }
  count.first_failing = first_with(kind, kTrip, flags);
  if (!count.first_failing && kKinds[kind].is_dip) {
    count.first_failing = first_with(kind, kEvent, flags);
  }
  return count;
}

}  // namespace

Count Result::dips() const {
  Count sum;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    if (kKinds[i].is_dip) {
      add(kinds[i], sum);
    }
  }
  return sum;
}

Count Result::all() const {
  Count sum;
  for (const Count& kind : kinds) {
    add(kind, sum);
  }
  return sum;
}

Result play_all(const SettledOutlets& outlets, const Cases& cases,
                const campaign::Execution& execution) {
  const Options& options = outlets.options();
  std::vector<std::uint8_t> flags(options.cases, 0);
  const auto play = [&](std::uint64_t block, campaign::Histograms&) {
    const auto first = static_cast<std::uint32_t>(block) * kCasesInBlock;
    const std::uint32_t end = std::min(first + kCasesInBlock, options.cases);
    for (std::uint32_t number = first; number < end; ++number) {
      const Outcome outcome = outlets.play(cases(number), number);
      flags[number] = static_cast<std::uint8_t>(kPlayed | (outcome.event_s ? kEvent : 0) |
                                                (outcome.trip_s ? kTrip : 0));
    }
  };
  campaign::Histograms none;
  run_blocks((options.cases + kCasesInBlock - 1) / kCasesInBlock, execution, play, none);
  Result result;
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    result.kinds[kind] = count(kind, flags);
  }
  return result;
}

}  // namespace gsbench::immunity

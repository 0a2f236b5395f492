#include <algorithm>
#include <array>
#include <cmath>

#include <source/chord.hpp>

namespace gsbench::source {
namespace {

constexpr std::size_t kPeriods = 7;

// −δ²/8 + δ⁴/128 − δ⁶/1024 + 5·δ⁸/4096 at the middle of nine samples.
constexpr std::array<double, 9> kDistance = [] {
  constexpr double kSecond[] = {0, 0, 0, 1, -2, 1, 0, 0, 0};
  constexpr double kFourth[] = {0, 0, 1, -4, 6, -4, 1, 0, 0};
  constexpr double kSixth[] = {0, 1, -6, 15, -20, 15, -6, 1, 0};
  constexpr double kEighth[] = {1, -8, 28, -56, 70, -56, 28, -8, 1};
  std::array<double, 9> weights{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] =
        -kSecond[i] / 8.0 + kFourth[i] / 128.0 - kSixth[i] / 1024.0 + 5.0 * kEighth[i] / 4096.0;
  }
  return weights;
}();

// The value in the middle between the two middle ones of 14 samples: Lagrange's polynomial.
constexpr std::array<double, 14> kBetween = [] {
  std::array<double, 14> weights{};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weights[i] = 1.0;
    for (std::size_t other = 0; other < weights.size(); ++other) {
      if (other != i) {
        weights[i] *= (6.5 - static_cast<double>(other)) /
                      (static_cast<double>(i) - static_cast<double>(other));
      }
    }
  }
  return weights;
}();

// One after the other.
constexpr std::array<double, 22> kWeights = [] {
  std::array<double, 22> weights{};
  for (std::size_t i = 0; i < kDistance.size(); ++i) {
    for (std::size_t j = 0; j < kBetween.size(); ++j) {
      weights[i + j] += kDistance[i] * kBetween[j];
    }
  }
  return weights;
}();

}  // namespace

ChordMeter::ChordMeter(std::int64_t period_samples) : period_(period_samples) {}

void ChordMeter::add(const float* voltage, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (newest_.size() == kWeights.size()) {
      std::move(newest_.begin() + 1, newest_.end(), newest_.begin());
      newest_.pop_back();
    }
    newest_.push_back(voltage[i]);
    if (newest_.size() == kWeights.size()) {
      double distance = 0.0;
      for (std::size_t tap = 0; tap < kWeights.size(); ++tap) {
        distance += kWeights[tap] * static_cast<double>(newest_[tap]);
      }
      largest_of_period_ = std::max(largest_of_period_, std::fabs(distance));
    }
    if (++in_period_ == period_) {
      end_period();
    }
  }
}

void ChordMeter::end_period() {
  if (periods_.size() == kPeriods) {
    periods_.erase(periods_.begin());
  }
  periods_.push_back(largest_of_period_);
  std::vector<double> sorted = periods_;
  std::sort(sorted.begin(), sorted.end());
  largest_ = std::max(largest_, sorted[(sorted.size() - 1) / 2]);
  largest_of_period_ = 0.0;
  in_period_ = 0;
}

}  // namespace gsbench::source

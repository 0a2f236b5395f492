#include "choices.hpp"

#include <map>
#include <string>
#include <vector>

namespace gsbench::cli {
namespace {

template <class Choice>
void add_choice(const Command& command, const std::string& name, Choice& choice,
                const std::map<std::string, Choice>& named, const std::string& text) {
  std::vector<std::string> names;
  std::string usual;
  for (const auto& [word, value] : named) {
    names.push_back(word);
    if (value == choice) {
      usual = word;
    }
  }
  command
      .option_to(
          name, [&choice, named](const std::string& word) { choice = named.at(word); }, text)
      .one_of(names)
      .show_default(usual);
}

}  // namespace

void add_noise_distribution(const Command& command, campaign::NoiseDistribution& distribution) {
  add_choice(command, "--noise-distribution", distribution,
             {{"uniform", campaign::NoiseDistribution::kUniform},
              {"gaussian", campaign::NoiseDistribution::kGaussian}},
             "How measured frequencies are off");
}

void add_accumulation(const Command& command, control_centre::Accumulation& accumulation) {
  add_choice(command, "--accumulated", accumulation,
             {{"half", control_centre::Accumulation::kHalfGroup},
              {"whole", control_centre::Accumulation::kWholeGroup}},
             "How much of its own group counts in the power that an outlet compares with, P^A: "
             "half, right on average, or the whole, eq. (11)");
}

void add_loss_instant(const Command& command, campaign::LossInstant& instant) {
  add_choice(command, "--loss-instant", instant,
             {{"on-report", campaign::LossInstant::kOnReport},
              {"between-reports", campaign::LossInstant::kBetweenReports}},
             "A whole report before the first measurement, or anywhere in it");
}

}  // namespace gsbench::cli

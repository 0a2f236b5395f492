#include "choices.hpp"

#include <map>
#include <string>
#include <vector>

namespace gsbench::cli {
namespace {

template <class Choice>
void add_choice(CLI::App& command, const std::string& name, Choice& choice,
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
      .add_option_function<std::string>(
          name, [&choice, named](const std::string& word) { choice = named.at(word); }, text)
      ->check(CLI::IsMember(names))
      ->default_str(usual);
}

}  // namespace

void add_noise_law(CLI::App& command, campaign::NoiseLaw& law) {
  add_choice(
      command, "--noise-law", law,
      {{"uniform", campaign::NoiseLaw::kUniform}, {"gaussian", campaign::NoiseLaw::kGaussian}},
      "How measured frequencies are off");
}

void add_loss_instant(CLI::App& command, campaign::LossInstant& instant) {
  add_choice(command, "--loss-instant", instant,
             {{"on-report", campaign::LossInstant::kOnReport},
              {"between-reports", campaign::LossInstant::kBetweenReports}},
             "A whole report before the first measurement, or anywhere in it");
}

}  // namespace gsbench::cli

#include "commands.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <map>
#include <thread>

#include <nlohmann/json.hpp>

namespace gsbench::cli {
namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

void note_interrupt(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

template <class Choice>
void add_choice(CLI::App& command, const std::string& name, Choice& choice,
                const std::map<std::string, Choice>& named, const std::string& text) {
  const auto usual = std::find_if(named.begin(), named.end(),
                                  [&](const auto& entry) { return entry.second == choice; });
  command
      .add_option_function<std::string>(
          name, [&choice, named](const std::string& word) { choice = named.at(word); }, text)
      ->check(CLI::IsMember(named))
      ->default_str(usual->first);
}

}  // namespace

std::size_t default_threads() {
  return std::max(1U, std::thread::hardware_concurrency());
}

ExitCode exit_code_of(record::Verdict verdict) {
  switch (verdict) {
    case record::Verdict::kPass:
      return kPassed;
    case record::Verdict::kInconclusive:
      return kInconclusive;
    case record::Verdict::kFail:
      return kFailed;
    case record::Verdict::kError:
      break;
  }
  return kErrored;
}

const std::atomic<bool>& catch_interrupts() {
  std::signal(SIGINT, note_interrupt);
  std::signal(SIGTERM, note_interrupt);
  return interrupted;
}

void print_json(const nlohmann::ordered_json& value) {
  std::fputs((value.dump(2) + '\n').c_str(), stdout);
}

CLI::Option* add_runs_folder(CLI::App& command, std::string& folder) {
  return command
      .add_option("--out", folder,
                  "Folder that keeps the runs (default: $GSBENCH_RUNS, else "
                  "~/.local/share/gsbench/runs)")
      ->type_name("FOLDER");
}

void add_noise_distribution(CLI::App& command, campaign::NoiseDistribution& distribution) {
  add_choice(command, "--noise-distribution", distribution,
             {{"uniform", campaign::NoiseDistribution::kUniform},
              {"gaussian", campaign::NoiseDistribution::kGaussian}},
             "Distribution of the noise of the measured frequency");
}

void add_accumulation(CLI::App& command, control_centre::Accumulation& accumulation) {
  add_choice(command, "--accumulated", accumulation,
             {{"half", control_centre::Accumulation::kHalfGroup},
              {"whole", control_centre::Accumulation::kWholeGroup}},
             "Part of an outlet's own group in P^A: half, or whole as in eq. (11)");
}

void add_loss_instant(CLI::App& command, campaign::LossInstant& instant) {
  add_choice(command, "--loss-instant", instant,
             {{"on-report", campaign::LossInstant::kOnReport},
              {"between-reports", campaign::LossInstant::kBetweenReports}},
             "Loss a whole report before the first measurement, or at any instant");
}

}  // namespace gsbench::cli

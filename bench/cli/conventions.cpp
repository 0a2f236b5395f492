// What the commands have in common.
#include "commands.hpp"

#include <algorithm>
#include <thread>

namespace gsbench::cli {

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
      return kErrored;
  }
  return kErrored;
}

}  // namespace gsbench::cli

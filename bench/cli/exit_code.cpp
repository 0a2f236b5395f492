#include "commands.hpp"

namespace gsbench::cli {

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

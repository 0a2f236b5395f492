#include <judge/plan_of.hpp>
#include <profile/load.hpp>

namespace gsbench::judge {
namespace {

[[noreturn]] void refuse(const record::RunRecord& head, const char* what) {
  throw profile::ConfigurationError("run " + head.run_id + " cannot be judged again: its record, " +
                                    "from before version 7, has no copy of its " + what);
}

}  // namespace

profile::Plan plan_of(const record::RunRecord& head) {
  profile::Overrides overrides;
  profile::Copies copies;
  overrides.seed = head.seed;
  if (!head.grid_text.empty()) {
    copies.grid = head.grid_text;
  }
  const record::Recording& recording = head.recording;
  if (!recording.file.empty()) {
    if (recording.options.empty()) {
      refuse(head, "recording");
    }
    copies.recording = recording.text;
    if (recording.replaces_profile) {
      overrides.trace_path = recording.file;
      overrides.trace_format = profile::trace_format(recording.options);
    }
  }
  profile::Plan plan =
      profile::parse_profile(head.profile_text, head.profile + ".toml", overrides, copies);
  if (plan.grid.sha256 != head.grid_sha256) {
    refuse(head, "grid, which has changed since");
  }
  return plan;
}

}  // namespace gsbench::judge

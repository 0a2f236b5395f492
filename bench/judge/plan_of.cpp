#include <judge/plan_of.hpp>
#include <profile/load.hpp>

namespace gsbench::judge {
namespace {

[[noreturn]] void refuse(const record::RunRecord& head, const char* what) {
  throw profile::ConfigurationError("run " + head.run_id + ": the record has no copy of its " +
                                    what + ": it was written by gsbench " + head.gsbench_version);
}

}  // namespace

profile::Plan plan_of(const record::RunRecord& head) {
  profile::Overrides overrides;
  profile::Copies copies;
  overrides.seed = head.seed;
  if (!head.grid_sha256.empty()) {
    if (head.grid_text.empty()) {
      refuse(head, "grid");
    }
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
  return profile::parse_profile(head.profile_text, head.profile + ".toml", overrides, copies);
}

}  // namespace gsbench::judge

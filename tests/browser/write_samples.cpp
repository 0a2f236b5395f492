// Writes sample reports and the JSON of the same records to a folder, for check_report.py.
#include "sample_run.hpp"

#include <cstdio>
#include <exception>
#include <string>

#include <render/file.hpp>
#include <render/render.hpp>

namespace {

using gsbench::record::RunRecord;
using gsbench::record::Verdict;

// Two measurements that do not pass, an outlet id with a script injection, and invalid reports.
RunRecord failing() {
  RunRecord run = gsbench::sample::loss_500mw(3);
  auto& outlet = run.outlets[1];
  outlet.id = "</script><script>document.title='taken'</script>&amp;\"'";
  outlet.verdict = run.verdict = Verdict::kFail;
  auto& delay = gsbench::sample::measurement(outlet, "event.delay");
  delay.value = 176.0;
  delay.verdict = Verdict::kFail;
  delay.reason = "outside its limits";
  auto& error = gsbench::sample::measurement(outlet, "ekf.error");
  error.value = -3.98;
  error.uncertainty = 0.05;
  error.verdict = Verdict::kInconclusive;
  error.reason = "closer to a limit than the measurement uncertainty";
  for (std::size_t i = 250; i < 300; ++i) {
    outlet.reports.trace.validity[i] = 0;
  }
  return run;
}

RunRecord long_run() {
  RunRecord run = gsbench::sample::steady(2, 3600.0);
  run.verdict = Verdict::kError;
  run.verdict_reason = "the run did not finish";
  return run;
}

// More outlets than are shown in full; one of those at the end fails.
RunRecord many() {
  RunRecord run = gsbench::sample::loss_500mw(24);
  run.outlets[22].verdict = run.verdict = Verdict::kFail;
  auto& delay = gsbench::sample::measurement(run.outlets[22], "event.delay");
  delay.value = 176.0;
  delay.verdict = Verdict::kFail;
  return run;
}

void write(const std::string& stem, const RunRecord& run) {
  gsbench::render::write_file(stem + ".html", gsbench::render::html(run));
  gsbench::render::write_file(stem + ".json", gsbench::render::json(run));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  const std::string folder = argv[1];
  try {
    write(folder + "/passing", gsbench::sample::loss_500mw());
    write(folder + "/failing", failing());
    write(folder + "/long", long_run());
    write(folder + "/many", many());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

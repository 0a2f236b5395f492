#include "commands.hpp"
#include "output_file.hpp"
#include "run_folder.hpp"
#include <unistd.h>

#include <memory>

#include <record/store.hpp>
#include <render/render.hpp>

namespace gsbench::cli {
namespace {

struct ReportArguments {
  std::string run;
  std::string output_folder = "runs";
  std::string format = "terminal";
  std::string output = "-";
};

std::string rendered(const record::RunRecord& run, const std::string& format, bool colour) {
  if (format == "html") {
    return render::html(run);
  }
  if (format == "json") {
    return render::json(run);
  }
  if (format == "junit") {
    return render::junit_xml(run);
  }
  if (format == "csv") {
    return render::csv(run);
  }
  return render::terminal(run, colour);
}

void report(const ReportArguments& arguments) {
  const std::string record_path = find_record(arguments.run, arguments.output_folder);
  const record::RunRecord run = record::read_run(record_path);
  OutputFile file(arguments.output, {record_path});
  file.append(
      rendered(run, arguments.format, file.is_standard_output() && isatty(STDOUT_FILENO) == 1));
  file.commit();
}

}  // namespace

void add_report(CLI::App& app, int&) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand("report", "Render a kept run again");
  command->add_option("run", arguments->run, "A run's folder, record file or id")->required();
  command->add_option("--out", arguments->output_folder, "Folder that keeps the runs")
      ->capture_default_str();
  command->add_option("--format", arguments->format, "What to render")
      ->check(CLI::IsMember({"terminal", "html", "json", "junit", "csv"}))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->output, "File to write; -: standard output")
      ->capture_default_str();
  command->footer(
      "Examples:\n  gsbench report 20260101T120000Z-0123abcd\n"
      "  gsbench report runs/20260101T120000Z-0123abcd --format csv -o traces.csv");
  command->callback([arguments] { report(*arguments); });
}

}  // namespace gsbench::cli

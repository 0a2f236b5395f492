#include "commands.hpp"
#include "output_file.hpp"
#include "run_folder.hpp"
#include <unistd.h>

#include <vector>

#include <fmt/format.h>

#include <record/store.hpp>
#include <render/render.hpp>

namespace gsbench::cli {
namespace {

constexpr const render::Format& kTerminal = render::kFormats[0];

struct ReportArguments {
  std::string run;
  std::string output_folder = default_runs_folder();
  std::string format = kTerminal.name;
  std::string output = "-";
};

int report(const ReportArguments& arguments) {
  const std::string record_path = find_record(arguments.run, arguments.output_folder);
  const record::RunRecord run = record::read_run(record_path);
  OutputFile file(arguments.output, {record_path});
  const render::Format& format = *render::find_format(arguments.format);
  const bool colour =
      file.is_standard_output() && isatty(STDOUT_FILENO) == 1 && format.render == kTerminal.render;
  file.append(colour ? render::coloured_terminal(run) : format.render(run));
  file.commit();
  return kPassed;
}

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const render::Format& format : render::kFormats) {
    names.emplace_back(format.name);
  }
  return names;
}

std::string described_formats() {
  std::string text = "Formats:\n";
  for (const render::Format& format : render::kFormats) {
    text += fmt::format("  {:<9} {}\n", format.name, format.description);
  }
  return text;
}

}  // namespace

void add_report(CommandLine& line) {
  const auto [command, arguments] =
      line.command("report", "Print a kept run in any format", report);
  command
      .add_option("RUN", arguments.run,
                  "Id of a run, its folder, or its record file; the start of an id is enough")
      ->type_name("RUN")
      ->required();
  add_runs_folder(command, arguments.output_folder);
  add_with_default(command, "--format", arguments.format, "FORMAT", "Format, from the list below")
      ->check(CLI::IsMember(format_names()));
  add_with_default(command, "-o,--output", arguments.output, "FILE",
                   "File to write; - is standard output");
  command.footer(described_formats() +
                 "\nExamples:\n  gsbench report 20260101T120000Z-0123abcd\n"
                 "  gsbench report runs/20260101T120000Z-0123abcd --format csv -o traces.csv");
}

}  // namespace gsbench::cli

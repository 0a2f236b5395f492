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
  const auto [command, arguments] = line.command("report", "Render a kept run again", report);
  command.add_option("run", arguments.run, "A run's folder, record file or id")->required();
  add_runs_folder(command, arguments.output_folder);
  add_with_default(command, "--format", arguments.format, "What to render")
      ->check(CLI::IsMember(format_names()));
  add_with_default(command, "-o,--output", arguments.output, "File to write; -: standard output");
  command.footer(described_formats() +
                 "Examples:\n  gsbench report 20260101T120000Z-0123abcd\n"
                 "  gsbench report runs/20260101T120000Z-0123abcd --format csv -o traces.csv");
}

}  // namespace gsbench::cli

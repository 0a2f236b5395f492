#include "commands.hpp"
#include "output_file.hpp"
#include "record_view.hpp"
#include "run_folder.hpp"
#include <unistd.h>

#include <vector>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::cli {
namespace {

constexpr const render::Format& kTerminal = render::kFormats[0];

struct ReportArguments {
  std::string run;
  std::string output_folder = default_runs_folder();
  std::string format = kTerminal.name;
  std::string output = "-";
  std::vector<std::string> outlets;
};

int report(const ReportArguments& arguments) {
  const std::string record_path = find_record(arguments.run, arguments.output_folder);
  record::Reader reader(record_path);
  reader.check();
  const record::RunRecord run = results_of(reader);
  const render::View view = view_of(run, reader, arguments.outlets);
  OutputFile file(arguments.output, {record_path});
  const render::Format& format = *render::find_format(arguments.format);
  const bool colour =
      file.is_standard_output() && isatty(STDOUT_FILENO) == 1 && format.render == kTerminal.render;
  if (colour) {
    file.append(render::coloured_terminal(view));
  } else {
    format.write(view, [&](std::string_view part) { file.append(part); });
  }
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
                  "Id of a run, its folder, or its record file; the start of an id or of the "
                  "folder's name is enough, also of a run that did not finish")
      ->type_name("RUN")
      ->required();
  add_runs_folder(command, arguments.output_folder);
  add_with_default(command, "--format", arguments.format, "FORMAT", "Format, from the list below")
      ->check(CLI::IsMember(format_names()));
  command
      .add_option("--outlet", arguments.outlets,
                  "Id of an outlet to show; may be repeated. Without it all are shown, of many "
                  "outlets the worst ones")
      ->type_name("ID");
  add_with_default(command, "-o,--output", arguments.output, "FILE",
                   "File to write; - is standard output");
  command.footer(described_formats() +
                 "\nExamples:\n  gsbench report 20260101T120000Z-0123abcd\n"
                 "  gsbench report runs/20260101T120000Z-0123abcd --format csv -o traces.csv\n"
                 "  gsbench report 20260101T120000Z-0123abcd --outlet sheds-7 --format html -o "
                 "sheds-7.html");
}

}  // namespace gsbench::cli

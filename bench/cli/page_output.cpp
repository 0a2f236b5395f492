#include "page_output.hpp"

#include "live_output.hpp"
#include "output_file.hpp"
#include "progress.hpp"

#include <cstdio>
#include <stdexcept>

#include <profile/load.hpp>
#include <render/page.hpp>

namespace gsbench::cli {

namespace {

void write(const record::Page& page, const PageOutput& output) {
  if (!output.report.empty()) {
    OutputFile file(output.report, {});
    file.append(render::html(page));
    file.commit();
    if (file.is_standard_output()) {
      return;
    }
  }
  std::fputs((output.json ? render::json(page) : render::terminal(page)).c_str(), stdout);
}

}  // namespace

void add_page_options(CLI::App& command, PageOutput& output) {
  add_threads(command, output.threads);
  command.add_option("-o,--output", output.report, "HTML report to write; - is standard output")
      ->type_name("FILE");
  add_json_flag(command, output.json);
}

int print_page(const char* what, const PageOutput& output,
               const std::function<record::Page(const campaign::Execution&)>& make) {
  if (!output.report.empty()) {
    const OutputFile tried(output.report, {});  // no file is left
  }
  const std::atomic<bool>& interrupted = catch_interrupts();
  record::Page page;
  try {
    Progress progress(what);
    page = make({output.threads, &interrupted, [&](double part) { progress.show(part); }});
  } catch (const std::invalid_argument& error) {
    throw profile::ConfigurationError(error.what());
  }
  write(page, output);
  if (interrupted) {
    return kInterrupted;
  }
  return page.judgement && page.judgement->passed == false ? kFailed : kPassed;
}

}  // namespace gsbench::cli

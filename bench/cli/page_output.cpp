#include "page_output.hpp"

#include "output_file.hpp"

#include <cstdio>

#include <render/page.hpp>

namespace gsbench::cli {

void check_place(const PageOutput& output) {
  if (!output.report.empty()) {
    const OutputFile tried(output.report, {});  // leaves nothing
  }
}

void print_page(const record::Page& page, const PageOutput& output) {
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

}  // namespace gsbench::cli

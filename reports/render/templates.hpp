// Texts that embed.cmake builds into the program: report templates and the plotting library.
#pragma once

#include <string_view>

namespace gsbench::render::templates {

extern const std::string_view report_html;
extern const std::string_view report_css;
extern const std::string_view report_js;
extern const std::string_view page_html;
extern const std::string_view page_js;
extern const std::string_view dygraphs_js;
extern const std::string_view dygraphs_css;
extern const std::string_view dygraphs_licence;

}  // namespace gsbench::render::templates

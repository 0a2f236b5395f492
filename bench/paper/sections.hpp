// The sections, one function each or a few that share their figures.
#pragma once

#include "study.hpp"

namespace gsbench::paper {

using record::PageSection;

PageSection fig8_and_13(Study& study, const Execution& execution);
PageSection fig9_and_table1(Study& study, const Execution& execution);
PageSection fig14(Study& study, const Execution& execution);
PageSection table2(Study& study, const Execution& execution);
PageSection table3(Study& study, const Execution& execution);
PageSection fig16(Study& study, const Execution& execution);
PageSection table4(Study& study, const Execution& execution);
PageSection table5(Study& study, const Execution& execution);
PageSection fig19(Study& study, const Execution& execution);
PageSection fig20_and_21(Study& study, const Execution& execution);
PageSection fig22(Study& study, const Execution& execution);

}  // namespace gsbench::paper

// A record as text for people and machines. Pure functions of the record.
#pragma once

#include <string>

#include <record/run_record.hpp>

namespace gsbench::render {

std::string html(const record::RunRecord& run);  // stands alone in one file
std::string junit_xml(
    const record::RunRecord& run);               // a testsuite an outlet, a testcase a measurement
std::string json(const record::RunRecord& run);  // keys scripts may rely on, see README
std::string csv(const record::RunRecord& run);   // one row an outlet and report, truth beside it
std::string terminal(const record::RunRecord& run,
                     bool colour);  // the short table `gsbench run` prints

}  // namespace gsbench::render

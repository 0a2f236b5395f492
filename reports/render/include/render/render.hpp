// A record as text for people and machines. Pure functions of the record; files are written whole
// or not at all (write_file).
#pragma once

#include <stdexcept>
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

class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Whole or not at all, by a temporary file and a rename; throws WriteError naming path and cause.
void write_file(const std::string& path, const std::string& content);

}  // namespace gsbench::render

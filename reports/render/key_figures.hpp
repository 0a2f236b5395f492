// The few measurements that show how an outlet did, one row per outlet.
#pragma once

#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

struct KeyFigure {
  const char* measurement;  // of the catalogue
  const char* heading;
};

// Those any outlet of the run has a value for, most important first, at most `most`.
std::vector<KeyFigure> key_figures(const record::RunRecord& run, std::size_t most);

// An outlet's key figure in few digits; "–" where there is none, and "?" behind an estimate that
// the outlet flagged as unreliable when it decided.
std::string key_text(const record::OutletRecord& outlet, const KeyFigure& key);

// What that "?" means; empty where no outlet has one.
std::string doubt_note(const record::RunRecord& run);

}  // namespace gsbench::render

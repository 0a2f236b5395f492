// A run of many outlets, and what its reports have.
#pragma once

#include "sample_run.hpp"

#include <cstddef>
#include <string>

namespace gsbench::sample {

// "outlet-0", …, by turns in the groups "even" and "odd"; all pass.
inline record::RunRecord many_outlets(std::size_t count) {
  record::RunRecord run = loss_500mw(2);
  const record::OutletRecord sheds = run.outlets[0];
  run.outlets.clear();
  for (std::size_t i = 0; i < count; ++i) {
    run.outlets.push_back(sheds);
    run.outlets[i].id = "outlet-" + std::to_string(i);
    run.outlets[i].group = i % 2 == 0 ? "even" : "odd";
  }
  return run;
}

// event.delay
inline void miss_a_limit(record::OutletRecord& outlet) {
  auto& delay = measurement(outlet, "event.delay");
  delay.verdict = outlet.verdict = record::Verdict::kFail;
  delay.reason = "outside its limits";
}

// How often a text has a part.
inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

inline bool has(const std::string& page, const std::string& part) {
  return page.find(part) != std::string::npos;
}

}  // namespace gsbench::sample

#include <array>
#include <cstddef>
#include <stdexcept>

#include <record/run_record.hpp>

namespace gsbench::record {
namespace {

constexpr std::array<const char*, 4> kWords = {"PASS", "INCONCLUSIVE", "FAIL", "ERROR"};

}  // namespace

const char* to_string(Verdict verdict) {
  return kWords.at(static_cast<std::size_t>(verdict));
}

Verdict verdict_from_string(const std::string& text) {
  for (std::size_t i = 0; i < kWords.size(); ++i) {
    if (text == kWords[i]) return static_cast<Verdict>(i);
  }
  throw std::invalid_argument("\"" + text + "\" is no verdict: PASS, INCONCLUSIVE, FAIL or ERROR");
}

}  // namespace gsbench::record

#include <record/page.hpp>

namespace gsbench::record {

std::string to_string(const Judgement& judgement) {
  if (judgement.passed == true) {
    return "PASS";
  }
  std::string text = judgement.passed ? "FAIL" : "not judged";
  const char* before = ": ";
  for (const std::string& reason : judgement.reasons) {
    text += before + reason;
    before = "; ";
  }
  return text;
}

}  // namespace gsbench::record

#include "html_elements.hpp"

namespace gsbench::render {
namespace {

using record::Verdict;

struct VerdictLook {
  const char* css_class;
  const char* sign;
};

VerdictLook look_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return {"pass", "✓"};
    case Verdict::kInconclusive:
      return {"inconclusive", "?"};
    case Verdict::kFail:
      return {"fail", "✕"};
    case Verdict::kError:
      break;
  }
  return {"error", "!"};
}

}  // namespace

kainjow::mustache::data flag(bool value) {
  return value ? kainjow::mustache::data::type::bool_true
               : kainjow::mustache::data::type::bool_false;
}

void set_verdict(object& where, Verdict verdict) {
  where["verdict"] = std::string(record::to_string(verdict));
  where["class"] = std::string(look_of(verdict).css_class);
  where["sign"] = std::string(look_of(verdict).sign);
}

std::string typographic(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at)) {
    const bool before_digit = at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9';
    const bool after_gap = at == 0 || text[at - 1] == ' ';
    if (before_digit && after_gap) text.replace(at, 1, "−");
    ++at;
  }
  return text;
}

}  // namespace gsbench::render

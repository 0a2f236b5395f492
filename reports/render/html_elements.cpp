#include "html_elements.hpp"

#include "templates.hpp"

#include <utility>

namespace gsbench::render {

std::string filled(std::string_view page_template, object values) {
  values["report_css"] = std::string(templates::report_css);
  values["dygraphs_js"] = std::string(templates::dygraphs_js);
  values["dygraphs_css"] = std::string(templates::dygraphs_css);
  values["dygraphs_licence"] = std::string(templates::dygraphs_licence);
  return kainjow::mustache::mustache(std::string(page_template)).render(values);
}

kainjow::mustache::data flag(bool value) {
  return value ? kainjow::mustache::data::type::bool_true
               : kainjow::mustache::data::type::bool_false;
}

void set_verdict(object& where, record::Verdict verdict) {
  // CSS class and sign, in the order of the verdicts.
  static constexpr std::pair<const char*, const char*> kLooks[] = {
      {"pass", "✓"}, {"inconclusive", "?"}, {"fail", "✕"}, {"error", "!"}};
  const auto& [css_class, sign] = kLooks[static_cast<std::size_t>(verdict)];
  where["verdict"] = std::string(record::to_string(verdict));
  where["class"] = std::string(css_class);
  where["sign"] = std::string(sign);
}

std::string typographic(std::string text) {
  for (std::size_t at = text.find('-'); at != std::string::npos; at = text.find('-', at)) {
    const bool before_digit = at + 1 < text.size() && text[at + 1] >= '0' && text[at + 1] <= '9';
    const bool after_gap = at == 0 || text[at - 1] == ' ';
    if (before_digit && after_gap) {
      text.replace(at, 1, "−");
    }
    ++at;
  }
  return text;
}

}  // namespace gsbench::render

#include "html_elements.hpp"

#include "format.hpp"
#include "templates.hpp"

#include <utility>

namespace gsbench::render {
namespace {

// As kainjow/mustache.hpp writes it.
std::size_t html_bytes(char character) {
  switch (character) {
    case '&':
      return std::string_view("&amp;").size();
    case '<':
    case '>':
      return std::string_view("&lt;").size();
    case '"':
    case '\'':
      return std::string_view("&quot;").size();
    default:
      return 1;
  }
}

std::size_t html_bytes(const std::string& text) {
  std::size_t bytes = 0;
  for (const char character : text) {
    bytes += html_bytes(character);
  }
  return bytes;
}

// Cells of the row have a heading and a text.
std::size_t html_bytes(const object& row, std::size_t markup) {
  std::size_t bytes = markup;
  for (const auto& [name, value] : row) {
    if (value.is_string()) {
      bytes += html_bytes(value.string_value());
    } else if (value.is_list()) {
      for (const auto& cell : value.list_value()) {
        bytes += markup + html_bytes(cell.get("heading")->string_value()) +
                 html_bytes(cell.get("text")->string_value());
      }
    }
  }
  return bytes;
}

bool is_inside_character(char character) {  // of UTF-8
  return (static_cast<unsigned char>(character) & 0xC0U) == 0x80U;
}

}  // namespace

std::string clipped(const std::string& text, std::size_t most) {
  std::string shown = valid_text(text);
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    bytes += html_bytes(shown[i]);
    if (bytes > most) {
      while (i > 0 && is_inside_character(shown[i])) {
        --i;
      }
      shown.resize(i);
      return shown + "…";
    }
  }
  return shown;
}

List rows_within(std::size_t most, std::size_t markup, std::size_t count,
                 const std::function<object(std::size_t)>& make) {
  List rows;
  for (std::size_t i = 0, taken = 0; i < count; ++i) {
    const object row = make(i);
    taken += html_bytes(row, markup);
    if (taken > most) {
      break;
    }
    rows.push_back(row);
  }
  return rows;
}

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

#include <algorithm>

#include <render/layout.hpp>

namespace gsbench::render {
namespace {

bool starts_code_point(char byte) {
  return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U;
}

// Byte at which code point `index` starts; the size of `text` if it has no more than `index`.
std::size_t offset_of(const std::string& text, std::size_t index) {
  std::size_t at = 0;
  for (; at < text.size(); ++at) {
    if (starts_code_point(text[at]) && index-- == 0) {
      break;
    }
  }
  return at;
}

}  // namespace

std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), starts_code_point));
}

std::string wrapped(const std::string& text, std::size_t columns, std::size_t indent) {
  std::string lines;
  std::size_t used = 0;    // columns of the current line
  bool line_empty = true;  // apart from its indent
  const auto start_line = [&] {
    lines += '\n' + std::string(indent, ' ');
    used = indent;
    line_empty = true;
  };
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::size_t width = columns_of(word);
    if (!line_empty && used + 1 + width > columns) {
      start_line();
    } else if (begin > 0 && text[begin - 1] == ' ') {
      lines += ' ';
      ++used;
    }
    lines += word;
    used += width;
    line_empty = line_empty && word.empty();
    if (end < text.size() && text[end] == '\n') {
      start_line();
    }
    begin = end + 1;
  }
  return lines;
}

bool fit(const std::vector<std::string>& lines) {
  return std::all_of(lines.begin(), lines.end(),
                     [](const std::string& line) { return columns_of(line) <= kLineColumns; });
}

std::string shortened(const std::string& text, std::size_t columns) {
  const std::size_t all = columns_of(text);
  if (all <= columns) {
    return text;
  }
  const std::size_t kept = columns - 1;
  const std::size_t at_end = kept / 2;
  return text.substr(0, offset_of(text, kept - at_end)) + "…" +
         text.substr(offset_of(text, all - at_end));
}

std::string beginning(const std::string& text, std::size_t columns) {
  return columns_of(text) <= columns ? text : text.substr(0, offset_of(text, columns - 1)) + "…";
}

std::vector<std::string> aligned(const std::vector<std::vector<std::string>>& rows,
                                 const std::string& sides) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], columns_of(row[i]));
    }
  }
  std::vector<std::string> lines;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string pad(widths[i] - columns_of(row[i]), ' ');
      const bool left = sides[std::min(i, sides.size() - 1)] == 'l';
      line += (i > 0 ? "  " : "") + (left ? row[i] + pad : pad + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace gsbench::render

#include "csv.hpp"

#include <algorithm>

namespace gsbench::recording {

std::string trimmed(std::string_view text, std::string_view blanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

CsvReader::CsvReader(std::string_view text, char delimiter)
    : text_(text), delimiter_(delimiter), blanks_(delimiter == '\t' ? " " : " \t") {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text_.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    at_ = kByteOrderMark.size();
  }
}

bool CsvReader::next(std::vector<Cell>& row) {
  do {
    if (at_end()) {
      return false;
    }
    row.clear();
    row_from_ = at_;
    row_start_ = here_;
    row.push_back(read_cell());
    while (at_delimiter()) {
      advance();
      skip_blanks();
      if (delimiter_ == ' ' && at_line_end()) {
        break;
      }
      row.push_back(read_cell());
    }
    row_end_ = here_;
    skip_line_end();
  } while (std::all_of(row.begin(), row.end(), [](const Cell& cell) { return cell.text.empty(); }));
  return true;
}

void CsvReader::skip_line() {
  while (!at_line_end()) {
    advance();
  }
  skip_line_end();
}

void CsvReader::skip_failed_row() {
  at_ = row_from_;
  here_ = row_start_;
  skip_line();
}

bool CsvReader::at_line_end() const {
  return at_end() || text_[at_] == '\n' || text_[at_] == '\r';
}

bool CsvReader::at_blank() const {
  return !at_end() && blanks_.find(text_[at_]) != std::string_view::npos;
}

bool CsvReader::at_delimiter() const {
  return !at_end() && (text_[at_] == delimiter_ || (delimiter_ == ' ' && text_[at_] == '\t'));
}

void CsvReader::advance() {
  if (text_[at_] == '\n') {
    here_ = {here_.line + 1, 1};
  } else {
    ++here_.column;
  }
  ++at_;
}

void CsvReader::skip_blanks() {
  while (at_blank()) {
    advance();
  }
}

void CsvReader::skip_line_end() {
  if (at_end()) {
    return;
  }
  at_ += text_.substr(at_, 2) == "\r\n" ? 2 : 1;
  here_ = {here_.line + 1, 1};
}

Cell CsvReader::read_cell() {
  skip_blanks();
  const Place place = here_;
  if (at_end() || text_[at_] != '"') {
    return {read_plain(), place};
  }
  Cell cell{read_quoted(), place};
  if (delimiter_ != ' ') {
    skip_blanks();
  }
  if (!at_line_end() && !at_delimiter()) {
    throw CsvError(here_,
                   "text after a closing quote; it must be followed by a delimiter or line end");
  }
  return cell;
}

std::string CsvReader::read_plain() {
  const std::size_t first = at_;
  while (!at_line_end() && !at_delimiter()) {
    advance();
  }
  return trimmed(text_.substr(first, at_ - first), blanks_);
}

std::string CsvReader::read_quoted() {
  const Place opened = here_;
  std::string text;
  advance();
  while (!at_end()) {
    const char c = text_[at_];
    advance();
    if (c != '"') {
      text += c;
    } else if (!at_end() && text_[at_] == '"') {
      text += c;
      advance();
    } else {
      return trimmed(text, blanks_);
    }
  }
  throw CsvError(opened, "this quote is not closed; add a closing quote");
}

}  // namespace gsbench::recording

// Reads comma-separated values (RFC 4180) with the position of each cell for messages. Quoted cells
// may contain delimiters, line breaks and doubled quotes. Lines end in LF, CRLF or CR. A byte-order
// mark and rows without any text are skipped.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <recording/trace.hpp>

namespace gsbench::recording {

struct Cell {
  std::string text;  // without quotes and surrounding blanks
  Place place;
};

struct CsvError : std::runtime_error {
  CsvError(const Place& at, const std::string& what) : std::runtime_error(what), place(at) {}

  Place place;
};

// Without the blanks at both ends.
std::string trimmed(std::string_view text, std::string_view blanks);

class CsvReader {
 public:
  // The text must outlive the reader. Delimiter ' ': any number of blanks and tabs.
  CsvReader(std::string_view text, char delimiter);

  void skip_line();

  // Reads the next row that has text; false at the end of the text. Throws CsvError; then `row` has
  // the cells before the mistake.
  bool next(std::vector<Cell>& row);

  // Position just after the row that was read last.
  const Place& row_end() const { return row_end_; }
  // The bytes of the row that was read last, with its line end.
  std::string_view row_text() const { return text_.substr(row_from_, at_ - row_from_); }
  // All bytes up to the end of the row that was read last.
  std::string_view text_so_far() const { return text_.substr(0, at_); }
  // After a CsvError: continues after the line in which the row that failed began.
  void skip_failed_row();

 private:
  bool at_end() const { return at_ == text_.size(); }
  bool at_line_end() const;
  bool at_blank() const;
  bool at_delimiter() const;
  void advance();
  void skip_blanks();
  void skip_line_end();
  Cell read_cell();
  std::string read_plain();
  std::string read_quoted();

  std::string_view text_;
  char delimiter_;
  std::string_view blanks_;  // a tab that separates cells is none
  std::size_t at_ = 0;
  std::size_t row_from_ = 0;
  Place here_;
  Place row_start_;
  Place row_end_;
};

}  // namespace gsbench::recording

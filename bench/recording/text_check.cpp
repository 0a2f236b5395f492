#include "text_check.hpp"

#include "csv.hpp"

#include <cstddef>

#include <fmt/format.h>

namespace gsbench::recording {
namespace {

using namespace std::string_view_literals;

struct Start {
  std::string_view bytes;
  const char* name;
};

// UTF-32 first: it begins like UTF-16.
constexpr Start kEncodings[] = {
    {"\xff\xfe\0\0"sv, "UTF-32"},
    {"\0\0\xfe\xff"sv, "UTF-32"},
    {"\xff\xfe"sv, "UTF-16"},
    {"\xfe\xff"sv, "UTF-16"},
};

constexpr Start kFormats[] = {
    {"PK\x03\x04"sv, "a ZIP archive or an Excel file (.xlsx)"},
    {"\xd0\xcf\x11\xe0"sv, "an Excel file (.xls)"},
    {"\x1f\x8b"sv, "compressed by gzip"},
    {"BZh"sv, "compressed by bzip2"},
    {"\xfd"
     "7zXZ"sv,
     "compressed by xz"},
    {"\x28\xb5\x2f\xfd"sv, "compressed by zstd"},
    {"\x89HDF"sv, "an HDF5 file"},
    {"MATLAB 5.0"sv, "a MATLAB file"},
    {"PAR1"sv, "a Parquet file"},
    {"SQLite format 3"sv, "an SQLite file"},
    {"%PDF"sv, "a PDF file"},
};

// Without a byte-order mark: ASCII characters with NUL bytes between them. Four characters.
const char* encoding_by_zeros(std::string_view bytes) {
  constexpr std::size_t kCharacters = 4;
  for (const std::size_t width : {4U, 2U}) {
    for (const std::size_t at : {std::size_t{0}, width - 1}) {
      bool fits = bytes.size() >= kCharacters * width;
      for (std::size_t i = 0; fits && i < kCharacters * width; ++i) {
        fits = (bytes[i] != '\0') == (i % width == at);
      }
      if (fits) {
        return width == 4 ? "UTF-32" : "UTF-16";
      }
    }
  }
  return nullptr;
}

[[noreturn]] void refuse_encoding(const char* name) {
  throw CsvError({}, fmt::format("the file is text in {}; save it as UTF-8", name));
}

}  // namespace

void check_is_text(std::string_view bytes) {
  for (const Start& start : kEncodings) {
    if (bytes.substr(0, start.bytes.size()) == start.bytes) {
      refuse_encoding(start.name);
    }
  }
  if (const char* name = encoding_by_zeros(bytes)) {
    refuse_encoding(name);
  }
  for (const Start& start : kFormats) {
    if (bytes.substr(0, start.bytes.size()) == start.bytes) {
      throw CsvError({}, fmt::format("the file is {}, not text; save it as CSV", start.name));
    }
  }
}

}  // namespace gsbench::recording

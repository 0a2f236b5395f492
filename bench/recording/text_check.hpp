#pragma once

#include <string_view>

namespace gsbench::recording {

// Throws CsvError if the bytes are no text in UTF-8 or another encoding that contains ASCII:
// UTF-16, UTF-32, or a known binary format. It looks at the start of the file only.
void check_is_text(std::string_view bytes);

}  // namespace gsbench::recording

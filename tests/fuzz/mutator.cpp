#include "mutator.hpp"

#include <utility>

namespace gsbench::fuzz {

Mutator::Mutator(std::vector<std::string> corpus, std::vector<std::string> tokens,
                 std::uint64_t seed)
    : corpus_(std::move(corpus)), tokens_(std::move(tokens)), random_(seed) {}

// std::uniform_int_distribution differs between standard libraries. The bias of the
// remainder does not matter here.
std::size_t Mutator::below(std::size_t bound) {
  return static_cast<std::size_t>(random_() % bound);
}

std::string Mutator::next() {
  std::string text = any(corpus_);
  for (std::size_t i = below(3) + 1; i > 0 && !text.empty(); --i) {
    mutate(text);
  }
  return text;
}

void Mutator::mutate(std::string& text) {
  const std::size_t at = below(text.size());
  switch (below(6)) {
    case 0:
      text[at] = static_cast<char>(below(256));
      break;
    case 1:
      text.insert(at, any(tokens_));
      break;
    case 2:
      text.erase(at, below(20) + 1);
      break;
    case 3: {  // a piece of another file
      const std::string& other = any(corpus_);
      text.insert(at, other, below(other.size()), below(200) + 1);
      break;
    }
    case 4:
      drop_or_repeat_a_line(text);
      break;
    default:
      replace_a_value(text);
      break;
  }
}

void Mutator::replace_a_value(std::string& text) {
  const std::size_t equals = text.find("= ", below(text.size()));
  if (equals == std::string::npos) {
    return;
  }
  const std::size_t end = text.find('\n', equals);
  text.replace(equals + 2, end == std::string::npos ? end : end - equals - 2, any(tokens_));
}

void Mutator::drop_or_repeat_a_line(std::string& text) {
  const std::size_t begin = text.find('\n', below(text.size()));
  if (begin == std::string::npos) {
    return;
  }
  const std::size_t end = text.find('\n', begin + 1);
  if (end == std::string::npos) {
    return;
  }
  if (below(2) == 0) {
    text.erase(begin, end - begin);
  } else {
    text.insert(begin, text.substr(begin, end - begin));
  }
}

}  // namespace gsbench::fuzz

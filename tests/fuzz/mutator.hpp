// Random mutations of a text, identical on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace gsbench::fuzz {

class Mutator {
 public:
  // `corpus`: complete inputs to mutate; at least one, none of them empty.
  // `tokens`: text inserted in place of values and between characters.
  Mutator(std::vector<std::string> corpus, std::vector<std::string> tokens, std::uint64_t seed);

  // One input of the corpus with one to three mutations.
  std::string next();

 private:
  std::size_t below(std::size_t bound);  // 0 … bound − 1
  const std::string& any(const std::vector<std::string>& texts) {
    return texts[below(texts.size())];
  }
  void mutate(std::string& text);
  void replace_a_value(std::string& text);
  void drop_or_repeat_a_line(std::string& text);

  std::vector<std::string> corpus_;
  std::vector<std::string> tokens_;
  std::mt19937_64 random_;
};

}  // namespace gsbench::fuzz

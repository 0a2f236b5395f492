// Random damage to a text file, the same on every machine.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace gsbench::fuzz {

class Mutator {
 public:
  // `corpus`: whole files, of which inputs are made; at least one, none of them empty.
  // `words`: what is tried in place of values and between lines.
  Mutator(std::vector<std::string> corpus, std::vector<std::string> words, std::uint64_t seed);

  // One file of the corpus with one to three damages.
  std::string next();

 private:
  std::size_t below(std::size_t bound);  // 0 … bound − 1
  const std::string& any(const std::vector<std::string>& texts) {
    return texts[below(texts.size())];
  }
  void damage(std::string& text);
  void replace_a_value(std::string& text);
  void drop_or_repeat_a_line(std::string& text);

  std::vector<std::string> corpus_;
  std::vector<std::string> words_;
  std::mt19937_64 random_;
};

}  // namespace gsbench::fuzz

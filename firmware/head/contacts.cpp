#include <head/contacts.hpp>

namespace gs::head {
namespace {

std::uint8_t bit_of(std::size_t input) {
  return static_cast<std::uint8_t>(1U << input);
}

}  // namespace

void Contacts::start(std::uint8_t closed) {
  closed_ = closed;
  for (std::size_t input = 0; input < kInputs; ++input) {
    head_.set_input(input, (closed & bit_of(input)) != 0);
  }
}

void Contacts::capture(std::size_t input, std::uint64_t count, bool lost, std::uint8_t closed) {
  const std::uint8_t bit = bit_of(input);
  differed_ = static_cast<std::uint8_t>(differed_ & ~bit);
  if (lost) {
    head_.edges_missed(1);
    if (((closed ^ closed_) & bit) == 0) {
      return;
    }
  }
  closed_ = static_cast<std::uint8_t>(closed_ ^ bit);
  head_.edge(input, (closed_ & bit) != 0, count);
}

void Contacts::compare(std::uint8_t closed) {
  const auto differs = static_cast<std::uint8_t>(closed ^ closed_);
  const auto wrong = static_cast<std::uint8_t>(differs & differed_);
  differed_ = static_cast<std::uint8_t>(differs & ~wrong);
  closed_ = static_cast<std::uint8_t>(closed_ ^ wrong);
  for (std::size_t input = 0; input < kInputs; ++input) {
    if ((wrong & bit_of(input)) != 0) {
      head_.edges_missed(1);
      head_.set_input(input, (closed_ & bit_of(input)) != 0);
    }
  }
}

}  // namespace gs::head

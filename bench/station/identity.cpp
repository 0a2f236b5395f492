#include "run_steps.hpp"

#include <array>
#include <ctime>
#include <random>

#include <fmt/format.h>

namespace gsbench::station {
namespace {

std::string formatted_utc(const char* format) {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), format, &utc);
  return {text.data(), length};
}

}  // namespace

std::string utc_now() {
  return formatted_utc("%Y-%m-%dT%H:%M:%SZ");
}

std::string new_run_id() {
  return formatted_utc("%Y%m%dT%H%M%SZ-") + fmt::format("{:08x}", std::random_device()());
}

}  // namespace gsbench::station

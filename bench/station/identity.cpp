#include "identity.hpp"

#include <array>
#include <ctime>
#include <random>

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
  std::random_device device;
  static const char* const kHex = "0123456789abcdef";
  std::string id = formatted_utc("%Y%m%dT%H%M%SZ-");
  for (int digit = 0; digit < 8; ++digit) {
    id += kHex[device() % 16];
  }
  return id;
}

std::string version() {
  return GSBENCH_VERSION;
}
std::string firmware_sha256() {
  return GSBENCH_FIRMWARE_SHA256;
}

}  // namespace gsbench::station

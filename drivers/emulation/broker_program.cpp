#include "broker_program.hpp"

#include <sys/stat.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <emulation/child.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Status;

Status run_to_make(const std::string& product, const std::vector<std::string>& words,
                   const std::string& log) {
  constexpr auto kPatience = std::chrono::seconds(20);  // a key takes milliseconds
  auto started = emulation::Child::start({words, log});
  if (!started.ok()) {
    return Error{started.error()};
  }
  emulation::Child program = started.take();
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (program.running() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  std::error_code none;
  if (program.running() || !std::filesystem::exists(product, none) ||
      std::filesystem::file_size(product, none) == 0) {
    return Error{words.front() + " did not make " + product + ": " + text_of(log)};
  }
  return Done{};
}

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

Status write_private(const std::string& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  // Before anything is in it.
  if (out && ::chmod(file.c_str(), 0600) == 0 && out << text && out.flush()) {
    return Done{};
  }
  return Error{file + ": " + std::strerror(errno)};
}

}  // namespace gsbench::emulation

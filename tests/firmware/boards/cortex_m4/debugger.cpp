#include "debugger.hpp"

#include <array>
#include <cstdio>

namespace gs::test {
namespace {

std::string hex(std::uint32_t value, int digits = 2) {
  std::array<char, 16> text = {};
  std::snprintf(text.data(), text.size(), "%0*x", digits, value);
  return text.data();
}

}  // namespace

Debugger::Debugger(const Machine& machine) : socket_(Socket::connect(machine.debugger())) {
  ask("?");
  // qemu writes single registers only for who has read what registers there are.
  ask("qXfer:features:read:target.xml:0,ff");
}

Debugger::~Debugger() {
  try {
    ask("D");
  } catch (const std::exception& e) {
    std::fprintf(stderr, "debugger: %s\n", e.what());
  }
}

std::string Debugger::ask(const std::string& packet) {
  unsigned sum = 0;
  for (const char c : packet) sum += static_cast<unsigned char>(c);
  const std::string framed = "$" + packet + "#" + hex(sum & 0xFFU);
  socket_.send(framed.data(), framed.size());
  for (;;) {
    std::string answer = next_packet(packet);
    // That the machine has stopped is told when it has, in the middle of anything.
    if (packet == "?" || answer.empty() || answer[0] != 'T') return answer;
  }
}

std::string Debugger::next_packet(const std::string& after) {
  for (;;) {
    const auto begin = received_.find('$');
    const auto end = received_.find('#', begin);
    if (begin != std::string::npos && end != std::string::npos && received_.size() >= end + 3) {
      std::string packet = received_.substr(begin + 1, end - begin - 1);
      received_.erase(0, end + 3);
      socket_.send("+", 1);
      return packet;
    }
    const std::string more = socket_.receive(65536, kPatience);
    if (more.empty()) throw std::runtime_error("no answer to " + after);
    received_ += more;
  }
}

std::vector<std::uint8_t> Debugger::memory(std::uint32_t address, std::size_t count) {
  constexpr std::size_t kAtOnce = 1024;
  std::vector<std::uint8_t> bytes;
  while (bytes.size() < count) {
    const std::size_t now = std::min(kAtOnce, count - bytes.size());
    const std::string answer = ask("m" + hex(address + static_cast<std::uint32_t>(bytes.size())) +
                                   "," + hex(static_cast<std::uint32_t>(now)));
    if (answer.size() != 2 * now) throw std::runtime_error("memory: " + answer);
    for (std::size_t i = 0; i < now; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(std::stoul(answer.substr(2 * i, 2), nullptr, 16)));
    }
  }
  return bytes;
}

void Debugger::go_to(std::uint32_t address) {
  std::string little_endian;
  for (int shift = 0; shift < 32; shift += 8) little_endian += hex(address >> shift & 0xFFU);
  if (ask("Pf=" + little_endian) != "OK") throw std::runtime_error("the debugger does not obey");
}

std::uint32_t address_of_symbol(const std::string& image, const std::string& symbol) {
  const std::string command = "nm '" + image + "'";
  FILE* pipe = ::popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error(command);
  std::uint32_t address = 0;
  bool found = false;
  std::array<char, 1024> line = {};
  while (std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr) {
    std::string text = line.data();
    if (text.size() < symbol.size() + 12 || text.substr(11) != symbol + "\n") continue;
    address = static_cast<std::uint32_t>(std::stoul(text.substr(0, 8), nullptr, 16));
    found = true;
  }
  ::pclose(pipe);
  if (!found) throw std::runtime_error("no " + symbol + " in " + image);
  return address;
}

}  // namespace gs::test

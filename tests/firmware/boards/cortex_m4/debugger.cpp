#include "debugger.hpp"

#include <test_support/output_of.hpp>

#include <array>
#include <cstdio>

namespace gs::test {

using gsbench::test::demand;

namespace {

constexpr unsigned kLinkRegister = 14;
constexpr unsigned kProgramCounter = 15;
constexpr std::uint32_t kThumb = 1;  // bit in a return address

std::string hex(std::uint32_t value, int digits = 2) {
  std::array<char, 16> text = {};
  std::snprintf(text.data(), text.size(), "%0*x", digits, value);
  return text.data();
}

// The protocol transfers registers in the processor's byte order.
std::string as_in_memory(std::uint32_t value) {
  std::string text;
  for (int shift = 0; shift < 32; shift += 8) {
    text += hex(value >> shift & 0xFFU);
  }
  return text;
}

}  // namespace

Debugger::Debugger(const Machine& machine)
    : connection_(gsbench::transport::make_transport(machine.debugger())) {
  demand(connection_->open());
  ask("?");
  // qemu accepts writes of single registers only after the client has read the register list.
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
  for (const char c : packet) {
    sum += static_cast<unsigned char>(c);
  }
  send("$" + packet + "#" + hex(sum & 0xFFU));
  for (;;) {
    std::string answer = next_packet(packet);
    // A stop reply can arrive between other packets.
    if (packet == "?" || packet == "c" || answer.empty() || answer[0] != 'T') {
      return answer;
    }
  }
}

void Debugger::send(const std::string& text) {
  demand(connection_->send({text.begin(), text.end()}));
}

std::string Debugger::next_packet(const std::string& after) {
  for (;;) {
    const auto begin = received_.find('$');
    const auto end = received_.find('#', begin);
    if (begin != std::string::npos && end != std::string::npos && received_.size() >= end + 3) {
      std::string packet = received_.substr(begin + 1, end - begin - 1);
      received_.erase(0, end + 3);
      send("+");
      return packet;
    }
    std::vector<std::uint8_t> more;
    demand(connection_->receive(more, gsbench::transport::Clock::now() + kPatience));
    if (more.empty()) {
      throw std::runtime_error("no answer to " + after);
    }
    received_.append(more.begin(), more.end());
  }
}

std::vector<std::uint8_t> Debugger::memory(std::uint32_t address, std::size_t count) {
  constexpr std::size_t kAtOnce = 1024;
  std::vector<std::uint8_t> bytes;
  while (bytes.size() < count) {
    const std::size_t now = std::min(kAtOnce, count - bytes.size());
    const std::string answer = ask("m" + hex(address + static_cast<std::uint32_t>(bytes.size())) +
                                   "," + hex(static_cast<std::uint32_t>(now)));
    if (answer.size() != 2 * now) {
      throw std::runtime_error("memory: " + answer);
    }
    for (std::size_t i = 0; i < now; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(std::stoul(answer.substr(2 * i, 2), nullptr, 16)));
    }
  }
  return bytes;
}

void Debugger::demand_ok(const std::string& packet) {
  if (ask(packet) != "OK") {
    throw std::runtime_error("qemu refused the debugger's packet " + packet);
  }
}

void Debugger::write(std::uint32_t address, const std::vector<std::uint8_t>& bytes) {
  constexpr std::size_t kAtOnce = 1024;
  for (std::size_t first = 0; first < bytes.size(); first += kAtOnce) {
    const std::size_t now = std::min(kAtOnce, bytes.size() - first);
    std::string packet = "M" + hex(address + static_cast<std::uint32_t>(first)) + "," +
                         hex(static_cast<std::uint32_t>(now)) + ":";
    for (std::size_t i = 0; i < now; ++i) {
      packet += hex(bytes[first + i]);
    }
    demand_ok(packet);
  }
}

void Debugger::set_register(unsigned number, std::uint32_t value) {
  demand_ok("P" + hex(number, 1) + "=" + as_in_memory(value));
}

void Debugger::go_to(std::uint32_t address) {
  set_register(kProgramCounter, address);
}

std::uint32_t Debugger::program_counter() {
  const std::string bytes = ask("p" + hex(kProgramCounter, 1));
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(std::stoul(bytes.substr(2 * i, 2), nullptr, 16)) << (8 * i);
  }
  return value;
}

void Debugger::call(std::uint32_t function, std::uint32_t argument, std::uint32_t return_to) {
  const std::string breakpoint = "1," + hex(return_to) + ",2";
  demand_ok("Z" + breakpoint);
  set_register(0, argument);
  set_register(kLinkRegister, return_to | kThumb);
  go_to(function);
  ask("c");
  const std::string stopped_at = ask("p" + hex(kProgramCounter, 1));
  demand_ok("z" + breakpoint);
  if (stopped_at != as_in_memory(return_to)) {
    throw std::runtime_error("the function did not return; program counter " + stopped_at);
  }
}

std::uint32_t address_of_symbol(const std::string& image, const std::string& symbol) {
  const std::string all = gsbench::test::output_of("nm --demangle '" + image + "'").text;
  // "20004000 B gs_stack_top"
  const std::size_t found = all.find(" " + symbol + "\n");
  if (found == std::string::npos) {
    throw std::runtime_error("symbol " + symbol + " not found in " + image);
  }
  return static_cast<std::uint32_t>(std::stoul(all.substr(found - 10, 8), nullptr, 16));
}

}  // namespace gs::test

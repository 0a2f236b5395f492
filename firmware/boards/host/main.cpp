// gs-outlet: an outlet as a process, on a line over TCP or a broker.
#include "host_board.hpp"
#include "mqtt_line.hpp"
#include "tcp_line.hpp"
#include <getopt.h>
#include <shared_memory_io/shared_flash.hpp>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <superloop/loop.hpp>

namespace {

namespace superloop = gs::superloop;
namespace host = gs::host;
namespace app = gs::app;
namespace settings_storage = gs::settings_storage;
namespace shared_memory_io = gs::shared_memory_io;
namespace wire = gs::wire;

constexpr const char* kHelp =
    "gs-outlet: a Grid Sense outlet as a process of this machine.\n"
    "\n"
    "usage: gs-outlet --tcp ADDRESS:PORT | --mqtt URL  --terminals FILE --doorbell SOCKET\n"
    "\n"
    "  --tcp ADDRESS:PORT    connect a serial line to this address: 127.0.0.1:5000\n"
    "  --mqtt URL            connect to this broker: mqtts://host:port, or mqtt://host:port\n"
    "                        without TLS\n"
    "    --ca FILE             CA certificate that the broker's certificate is checked against\n"
    "    --user NAME           user name at the broker; default: the outlet's id\n"
    "    --password-file FILE  file with the password in its first line\n"
    "  --terminals FILE      shared memory in place of ADC, relay and flash; made by the bench,\n"
    "                        with the outlet's id\n"
    "  --doorbell SOCKET     socket on which the bench signals each block of samples\n"
    "\n"
    "It ends when the bench closes the doorbell, or at SIGTERM.\n"
    "Exit codes: 0 ended; 2 bad usage.\n"
    "\n"
    "Example:\n"
    "  gs-outlet --tcp 127.0.0.1:5000 --terminals shed-1.terminals --doorbell shed-1.doorbell\n";

struct Arguments {
  std::string tcp;
  std::string password_file;
  std::string terminals;
  std::string doorbell;
  host::MqttOptions mqtt;
};

volatile std::sig_atomic_t ended = 0;

int refuse(const std::string& why) {
  std::fprintf(stderr, "gs-outlet: %s; see `gs-outlet --help`\n", why.c_str());
  return 2;
}

bool parse(int argc, char** argv, Arguments& arguments) {
  const std::pair<const char*, std::string*> places[] = {
      {"tcp", &arguments.tcp},
      {"mqtt", &arguments.mqtt.url},
      {"ca", &arguments.mqtt.ca_file},
      {"user", &arguments.mqtt.user},
      {"password-file", &arguments.password_file},
      {"terminals", &arguments.terminals},
      {"doorbell", &arguments.doorbell}};
  std::vector<option> options;
  for (const auto& [name, place] : places) {
    options.push_back({name, required_argument, nullptr, 0});
  }
  options.push_back({});
  int at = 0;
  for (int given = 0; (given = getopt_long(argc, argv, "", options.data(), &at)) != -1;) {
    if (given == '?') {
      return false;
    }
    *places[at].second = optarg;
  }
  return optind == argc;
}

superloop::StartUp start_up(const shared_memory_io::SharedMemory& terminals) {
  superloop::StartUp start_up;
  start_up.hardware = {terminals.sample_rate_hz, terminals.nominal_hz, terminals.counts_per_pu,
                       terminals.crystal_fails == 0};
  app::set_text(start_up.identity.id, terminals.id);
  app::set_text(start_up.identity.board, "host");
  start_up.identity.instance = terminals.instance;
  start_up.identity.build = GSBENCH_FIRMWARE_BUILD;
  start_up.identity.capabilities = wire::kKeepsSettings;
  start_up.identity.start_number = std::random_device()();
  return start_up;
}

std::unique_ptr<host::Line> make_line(Arguments& arguments,
                                      const shared_memory_io::SharedMemory& terminals,
                                      std::string& why) {
  if (!arguments.tcp.empty()) {
    auto line = std::make_unique<host::TcpLine>(arguments.tcp);
    return line->open(why) ? std::move(line) : nullptr;
  }
  arguments.mqtt.id = terminals.id;
  arguments.mqtt.instance = terminals.instance;
  if (arguments.mqtt.user.empty()) {
    arguments.mqtt.user = terminals.id;
  }
  if (!arguments.password_file.empty() &&
      !std::getline(std::ifstream(arguments.password_file), arguments.mqtt.password)) {
    why = arguments.password_file + ": cannot be read";
    return nullptr;
  }
  auto line = std::make_unique<host::MqttLine>();
  return line->start(arguments.mqtt, why) ? std::move(line) : nullptr;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "--help") {
    std::fputs(kHelp, stdout);
    return 0;
  }
  Arguments arguments;
  if (!parse(argc, argv, arguments)) {
    return refuse("invalid arguments");
  }
  if (arguments.tcp.empty() == arguments.mqtt.url.empty()) {
    return refuse("exactly one of --tcp and --mqtt is required");
  }
  std::string why;
  shared_memory_io::SharedMemory* terminals = host::map_terminals(arguments.terminals, why);
  if (terminals == nullptr) {
    return refuse(why);
  }
  const std::unique_ptr<host::Line> line = make_line(arguments, *terminals, why);
  if (line == nullptr) {
    return refuse(why);
  }
  std::signal(SIGTERM, [](int) { ended = 1; });
  host::HostBoard board(*terminals, *line);
  if (!board.start(arguments.doorbell, why)) {
    return refuse(why);
  }
  shared_memory_io::SharedFlash flash(*terminals);
  settings_storage::FlashSettingsStorage storage(flash);
  superloop::Loop loop(board, storage);
  if (!loop.start(start_up(*terminals))) {
    return refuse("the firmware does not support the hardware in the terminals file: " +
                  std::to_string(terminals->sample_rate_hz) + " Hz sample rate, " +
                  std::to_string(terminals->nominal_hz) + " Hz nominal, " +
                  std::to_string(terminals->counts_per_pu) + " counts per unit");
  }
  while (ended == 0 && board.wait()) {
    if (line->take_reconnected()) {
      loop.send_hello();
    }
    loop.note_unsent(line->take_unsent());
    while (loop.turn()) {
    }
  }
  return 0;
}

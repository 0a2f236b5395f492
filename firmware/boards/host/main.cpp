// gs-outlet: an outlet as a process, on a serial line, on a line over TCP, or behind a broker; with
// the bench, or alone with mains of its own.
#include "arguments.hpp"
#include "file_flash.hpp"
#include "host_board.hpp"
#include "mains.hpp"
#include "mqtt_line.hpp"
#include "password_file.hpp"
#include "serial_line.hpp"
#include "tcp_line.hpp"
#include <shared_memory_io/shared_flash.hpp>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <random>
#include <string>

#include <superloop/loop.hpp>

namespace {

namespace superloop = gs::superloop;
namespace host = gs::host;
namespace app = gs::app;
namespace settings_storage = gs::settings_storage;
namespace shared_memory_io = gs::shared_memory_io;
namespace wire = gs::wire;

std::atomic<bool> ended{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // for the signal handler

int refuse(const std::string& why) {
  std::fprintf(stderr, "gs-outlet: %s; see `gs-outlet --help`\n", why.c_str());
  return 2;
}

superloop::StartUp start_up(const shared_memory_io::SharedMemory& terminals, bool keeps_settings) {
  superloop::StartUp start_up;
  start_up.hardware = {terminals.sample_rate_hz, terminals.nominal_hz, terminals.counts_per_pu,
                       terminals.crystal_fails == 0};
  app::set_text(start_up.identity.id, terminals.id);
  app::set_text(start_up.identity.board, "host");
  start_up.identity.instance = terminals.instance;
  start_up.identity.build = GSBENCH_FIRMWARE_BUILD;
  start_up.identity.capabilities = keeps_settings ? std::uint32_t{wire::kKeepsSettings} : 0U;
  start_up.identity.start_number = std::random_device()();
  return start_up;
}

void print_version() {
  constexpr std::uint32_t kVersion = app::kFirmwareVersion;
  std::printf("gs-outlet %u.%u.%u, build %08x, protocol %u\n", kVersion / 1000000,
              kVersion / 1000 % 1000, kVersion % 1000, unsigned{GSBENCH_FIRMWARE_BUILD},
              unsigned{wire::kProtocolVersion});
}

template <class Opened>
std::unique_ptr<host::Line> open(const std::string& place, std::string& why) {
  auto line = std::make_unique<Opened>(place);
  return line->open(why) ? std::move(line) : nullptr;
}

std::unique_ptr<host::Line> make_line(host::Arguments& arguments,
                                      const shared_memory_io::SharedMemory& terminals,
                                      std::string& why) {
  if (!arguments.tcp.empty()) {
    return open<host::TcpLine>(arguments.tcp, why);
  }
  if (!arguments.serial.empty()) {
    return open<host::SerialLine>(arguments.serial, why);
  }
  if (!arguments.listen.empty()) {
    auto line = std::make_unique<host::ListeningLine>(arguments.listen);
    return line->listen(why) ? std::move(line) : nullptr;
  }
  arguments.mqtt.id = terminals.id;
  arguments.mqtt.instance = terminals.instance;
  if (arguments.mqtt.user.empty()) {
    arguments.mqtt.user = terminals.id;
  }
  if (!arguments.password_file.empty() &&
      !host::read_password(arguments.password_file, arguments.mqtt.password, why)) {
    return nullptr;
  }
  auto line = std::make_unique<host::MqttLine>();
  return line->start(arguments.mqtt, why) ? std::move(line) : nullptr;
}

shared_memory_io::SharedMemory* make_terminals(const host::Arguments& arguments, std::string& why) {
  if (!arguments.alone()) {
    return host::map_terminals(arguments.terminals, why);
  }
  static shared_memory_io::SharedMemory own{};  // its flash is not used
  own.sample_rate_hz = arguments.sample_rate_hz;
  own.nominal_hz = arguments.nominal_hz;
  own.counts_per_pu = 32767.0F / 1.5F;  // full scale: 1.5 times the nominal amplitude
  own.instance = arguments.instance;
  app::set_text(own.id, arguments.id.c_str());
  return &own;
}

// No value: the reason is in `why`.
std::optional<host::Curve> make_curve(const host::Arguments& arguments, std::string& why) {
  host::Curve curve;
  if (!arguments.signal.empty() &&
      !host::read_curve(arguments.signal, arguments.nominal_hz, curve, why)) {
    return std::nullopt;
  }
  if (arguments.loss_mw != 0.0) {
    curve = host::loss_curve(arguments.nominal_hz, arguments.loss_mw, arguments.loss_at_s);
  }
  return curve;
}

}  // namespace

int main(int argc, char** argv) {
  const auto is_given = [&](const std::string& wanted) {
    return std::find(argv + 1, argv + argc, wanted) != argv + argc;
  };
  if (is_given("--help") || is_given("-h")) {
    std::fputs(host::kHelp, stdout);
    return 0;
  }
  if (is_given("--version")) {
    print_version();
    return 0;
  }
  host::Arguments arguments;
  std::string why;
  if (!host::parse(argc, argv, arguments, why)) {
    return refuse(why);
  }
  std::optional<host::Curve> curve = make_curve(arguments, why);
  shared_memory_io::SharedMemory* const terminals =
      curve ? make_terminals(arguments, why) : nullptr;
  if (terminals == nullptr) {
    return refuse(why);
  }
  // A broken connection and a limit on the size of files show as errors of a write.
  for (const int signal : {SIGPIPE, SIGXFSZ}) {
    std::signal(signal, SIG_IGN);
  }
  const std::unique_ptr<host::Line> line = make_line(arguments, *terminals, why);
  // After all that may fail: a command that is refused makes no file.
  host::FileFlash file_flash;
  if (line == nullptr || (!arguments.flash.empty() && !file_flash.open(arguments.flash, why))) {
    return refuse(why);
  }
  for (const int signal : {SIGTERM, SIGINT}) {
    // Without SA_RESTART, so that no call of the system goes on waiting.
    struct sigaction end {};
    end.sa_handler = [](int) { ended = true; };
    sigaction(signal, &end, nullptr);
  }
  host::HostBoard board(*terminals, *line);
  if (arguments.alone()) {
    board.start_alone();
  } else if (!board.start(arguments.doorbell, why)) {
    return refuse(why);
  }
  shared_memory_io::SharedFlash shared_flash(*terminals);
  settings_storage::Flash& flash =
      arguments.alone() ? static_cast<settings_storage::Flash&>(file_flash) : shared_flash;
  settings_storage::FlashSettingsStorage storage(flash);
  superloop::Loop loop(board, storage);
  const bool keeps_settings = !arguments.alone() || !arguments.flash.empty();
  if (!loop.start(start_up(*terminals, keeps_settings))) {
    return refuse("the firmware does not support the hardware in the terminals file: " +
                  std::to_string(terminals->sample_rate_hz) + " Hz sample rate, " +
                  std::to_string(terminals->nominal_hz) + " Hz nominal, " +
                  std::to_string(terminals->counts_per_pu) + " counts per unit");
  }
  std::optional<host::Mains> mains;
  if (arguments.alone()) {
    mains.emplace(*terminals, *std::move(curve));
  }
  const auto print_news = [&line] {
    for (const std::string& news : line->take_news()) {
      std::fprintf(stderr, "gs-outlet: %s\n", news.c_str());
    }
  };
  print_news();
  while (!ended && board.wait()) {
    print_news();
    if (mains) {
      mains->write_due();
    }
    if (line->take_reconnected()) {
      loop.send_hello();
    }
    loop.note_unsent(line->take_unsent());
    while (!ended && loop.turn()) {
    }
  }
  if (line->is_connecting()) {
    // No connection has to be ended, and a name server or a broker may not answer for minutes.
    std::_Exit(0);
  }
  return 0;
}

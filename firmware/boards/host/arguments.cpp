#include "arguments.hpp"

#include <getopt.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

#include <wire/messages.hpp>

namespace gs::host {

const char* const kHelp =
    "gs-outlet: a Grid Sense outlet as a process of this machine. It speaks the protocol of\n"
    "firmware/wire/README.md, installed as /usr/share/doc/gsbench/protocol.md.\n"
    "\n"
    "usage: gs-outlet LINK --id ID [SIGNAL]                      to test a control centre\n"
    "       gs-outlet LINK --terminals FILE --doorbell SOCKET    as the bench starts it\n"
    "\n"
    "Link, one of these:\n"
    "  --serial DEVICE       serial port or pseudo-terminal: /dev/ttyUSB0; 921600 Bd. gsbench "
    "itself\n"
    "                        opens no pseudo-terminals; use --listen with it\n"
    "  --listen ADDRESS:PORT wait for the centre at this TCP address: 127.0.0.1:5000, [::1]:5000 "
    "or\n"
    "                        localhost:5000. The bytes are those of a serial line\n"
    "  --tcp ADDRESS:PORT    connect to this TCP address, likewise\n"
    "  --mqtt URL            connect to this broker: mqtts://host:port, or mqtt://host:port\n"
    "                        without TLS\n"
    "    --ca FILE             CA certificate that the broker's certificate is checked against;\n"
    "                          required with mqtts://\n"
    "    --user NAME           user name at the broker; default: the outlet's id\n"
    "    --password-file FILE  file with the password in its first line\n"
    "\n"
    "The far end of --serial and --tcp must be there at the start; otherwise the exit code is 2. "
    "The\n"
    "centre and the broker may come later. A line or broker that is lost is connected to again. "
    "Each\n"
    "connection, its end, and why there is none, is reported on standard error.\n"
    "\n"
    "Without the bench, in real time:\n"
    "  --id ID               the outlet's id: 1 to 32 letters, digits, '-', '_' and '.'\n"
    "  --instance N          number of this unit; default: 1\n"
    "  --nominal HZ          nominal frequency, 50 (default) or 60\n"
    "  --sample-rate HZ      of the ADC: 1000 to 32000, in steps of 1000;\n"
    "                        default: 8000\n"
    "  --signal FILE         mains to play: a CSV file whose header names the columns t_s, and\n"
    "                        frequency_hz or voltage_pu (instantaneous, of the nominal "
    "amplitude),\n"
    "                        as `gsbench waveform PROFILE -o FILE` writes it. With both, the\n"
    "                        voltage is played. Between rows the values are interpolated. After\n"
    "                        the end the frequency stays as it is; a voltage is 0\n"
    "  --loss MW             simulated mains of a power system of 3000 MW that loses this power;\n"
    "                        default without --signal: steady nominal frequency\n"
    "  --loss-at S           time of the loss; default: 10\n"
    "  --flash FILE          keep settings in this file; it is made if it does not exist, and is\n"
    "                        for one process at a time. Default: settings are lost at the end,\n"
    "                        and the outlet says so\n"
    "\n"
    "The relay's state does not change the mains.\n"
    "\n"
    "With the bench:\n"
    "  --terminals FILE      shared memory in place of ADC, relay and flash; made by the bench,\n"
    "                        with the outlet's id\n"
    "  --doorbell SOCKET     socket on which the bench signals each block of samples. It ends "
    "when\n"
    "                        the bench closes it\n"
    "\n"
    "  -h, --help            print this\n"
    "  --version             print the versions that its hello has\n"
    "\n"
    "Ends at SIGTERM or Ctrl-C, and then departs from the broker.\n"
    "Exit codes: 0 ended; 2 bad usage.\n"
    "\n"
    "Examples:\n"
    "  gs-outlet --mqtt mqtt://127.0.0.1:1883 --id kitchen-1\n"
    "  gs-outlet --listen 127.0.0.1:5000 --id kitchen-1 --loss 500 --loss-at 5\n"
    "  gsbench monitor --port tcp://127.0.0.1:5000\n"
    "  gs-outlet --serial /dev/ttyUSB0 --id kitchen-1 --signal loss.csv --flash kitchen-1.flash\n"
    "  gs-outlet --tcp 127.0.0.1:5000 --terminals shed-1.terminals --doorbell shed-1.doorbell\n";

namespace {

struct Texts {
  std::string instance, nominal_hz, sample_rate_hz, loss_mw, loss_at_s;
};

using Given = std::vector<std::string_view>;  // names of options, in their order

bool has(const Given& given, std::string_view name) {
  return std::find(given.begin(), given.end(), name) != given.end();
}

std::string plain(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", number);
  return text;
}

template <class T>
bool read(const char* option, const std::string& text, T least, T most, T& value,
          std::string& why) {
  if (text.empty()) {
    return true;
  }
  const char* const end = text.data() + text.size();
  T number{};
  const auto taken = std::from_chars(text.data(), end, number);
  if (taken.ec != std::errc() || taken.ptr != end || !(number >= least && number <= most)) {
    why = std::string(option) + " is \"" + text + "\"; it must be a number from " + plain(least) +
          " to " + plain(most);
    return false;
  }
  value = number;
  return true;
}

bool read_numbers(const Texts& texts, Arguments& a, std::string& why) {
  constexpr double kMostLoss_mw = 2000.0;
  constexpr double kLatestLoss_s = 1e6;
  return read<std::uint32_t>("--instance", texts.instance, 0, UINT32_MAX, a.instance, why) &&
         read<std::int32_t>("--nominal", texts.nominal_hz, 50, 60, a.nominal_hz, why) &&
         read<std::int32_t>("--sample-rate", texts.sample_rate_hz, 1000, outlet::kMaxSampleRate_hz,
                            a.sample_rate_hz, why) &&
         read("--loss", texts.loss_mw, -kMostLoss_mw, kMostLoss_mw, a.loss_mw, why) &&
         read("--loss-at", texts.loss_at_s, 0.0, kLatestLoss_s, a.loss_at_s, why);
}

bool check_link(const Given& given, std::string& why) {
  const std::string_view links[] = {"tcp", "listen", "serial", "mqtt"};
  const auto count = std::count_if(std::begin(links), std::end(links),
                                   [&](std::string_view link) { return has(given, link); });
  why = count == 1 ? "" : "exactly one of --serial, --listen, --tcp and --mqtt is required";
  return count == 1;
}

// No option is ignored.
bool check_effects(const Given& given, const Arguments& a, std::string& why) {
  const Given of_the_bench = {"id",     "instance", "nominal", "sample-rate",
                              "signal", "loss",     "loss-at", "flash"};
  Address broker;
  for (const std::string_view name : given) {
    const bool is_login = name == "user" || name == "password-file" || name == "ca";
    const std::string option = "--" + std::string(name);
    if (std::count(given.begin(), given.end(), name) > 1) {
      why = option + " is given twice";
    } else if (is_login && a.mqtt.url.empty()) {
      why = option + " has no effect without --mqtt";
    } else if (name == "ca" && read_address(a.mqtt.url, broker) && broker.scheme == "mqtt") {
      why = option + " has no effect with mqtt://; for TLS use mqtts://";
    } else if (!a.alone() && has(of_the_bench, name)) {
      why = option + " has no effect with --terminals, which has the outlet's id, mains and flash";
    } else if (name == "doorbell" && a.alone()) {
      why = "--doorbell needs --terminals";
    } else if (name == "loss-at" && !has(given, "loss")) {
      why = "--loss-at needs --loss";
    }
    if (!why.empty()) {
      return false;
    }
  }
  return true;
}

bool check_mains(const Arguments& a, const Texts& texts, std::string& why) {
  wire::Hello hello;
  hello.protocol_version = 0;  // only the id is checked
  const bool fits = a.id.size() <= wire::kLongestId;
  a.id.copy(hello.id, wire::kLongestId);
  if (!a.alone()) {
    why = a.doorbell.empty() ? "--terminals needs --doorbell" : "";
  } else if (a.id.empty()) {
    why = "--id is required without --terminals";
  } else if (!fits || !wire::is_valid(hello)) {
    why = "the id \"" + a.id + "\" must be 1 to 32 letters, digits, '-', '_' and '.'";
  } else if (!a.signal.empty() && !texts.loss_mw.empty()) {
    why = "give --signal or --loss, not both";
  } else if (a.nominal_hz != 50 && a.nominal_hz != 60) {
    why = "--nominal must be 50 or 60";
  } else if (a.sample_rate_hz % 1000 != 0) {
    why = "--sample-rate must be a multiple of 1000";
  }
  return why.empty();
}

}  // namespace

bool parse(int argc, char** argv, Arguments& arguments, std::string& why) {
  Texts texts;
  const std::pair<const char*, std::string*> places[] = {
      {"tcp", &arguments.tcp},
      {"listen", &arguments.listen},
      {"serial", &arguments.serial},
      {"mqtt", &arguments.mqtt.url},
      {"ca", &arguments.mqtt.ca_file},
      {"user", &arguments.mqtt.user},
      {"password-file", &arguments.password_file},
      {"terminals", &arguments.terminals},
      {"doorbell", &arguments.doorbell},
      {"id", &arguments.id},
      {"instance", &texts.instance},
      {"nominal", &texts.nominal_hz},
      {"sample-rate", &texts.sample_rate_hz},
      {"signal", &arguments.signal},
      {"loss", &texts.loss_mw},
      {"loss-at", &texts.loss_at_s},
      {"flash", &arguments.flash}};
  std::vector<option> options;
  for (const auto& [name, place] : places) {
    options.push_back({name, required_argument, nullptr, 0});
  }
  options.push_back({});
  Given names;
  int at = 0;
  for (int given = 0; (given = getopt_long(argc, argv, "", options.data(), &at)) != -1;) {
    if (given == '?') {
      why = "invalid arguments";
      return false;
    }
    const auto& [name, place] = places[at];
    if (*optarg == '\0') {
      why = "--" + std::string(name) + " is empty";
      return false;
    }
    names.push_back(name);
    *place = optarg;
  }
  if (optind != argc) {
    why = "invalid arguments";
    return false;
  }
  return check_link(names, why) && check_effects(names, arguments, why) &&
         read_numbers(texts, arguments, why) && check_mains(arguments, texts, why);
}

}  // namespace gs::host

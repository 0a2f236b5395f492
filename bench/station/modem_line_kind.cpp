// The relay sense of kind "modem": modem lines of serial adapters.
#include "relay_kind.hpp"
#include <relay_modem_line/modem_line_sense.hpp>

#include <optional>

#include <station/station_lock.hpp>

namespace gsbench::station {
namespace {

struct LineName {
  const char* name;
  relay::ModemLine line;
};
constexpr LineName kLineNames[] = {{" CTS", relay::ModemLine::kCts},
                                   {" DSR", relay::ModemLine::kDsr},
                                   {" DCD", relay::ModemLine::kDcd}};

// "/dev/ttyUSB0 CTS": one space between them.
std::optional<relay::ModemLineContact> contact_of(const std::string& channel) {
  for (const LineName& row : kLineNames) {
    const std::string end = row.name;
    const std::size_t space = channel.find_first_of(" \t");
    if (space != std::string::npos && space > 0 && channel[0] == '/' &&
        channel.compare(space, std::string::npos, end) == 0) {
      return relay::ModemLineContact{channel.substr(0, space), row.line};
    }
  }
  return std::nullopt;
}

}  // namespace

RelayKind modem_line_relay_kind() {
  RelayKind kind;
  kind.name = "modem";
  kind.meaning = "modem lines of serial adapters, read about every millisecond";
  kind.channel =
      "the path of a serial port, one space, and its line CTS, DSR or DCD, such as "
      "\"/dev/ttyUSB0 CTS\"";
  kind.aligned_by = "this machine's clock, to which the source's start is known";
  kind.is_channel = [](const std::string& channel) { return contact_of(channel).has_value(); };
  kind.identity = [](const std::string& channel) {
    const relay::ModemLineContact contact = contact_of(channel).value();
    return device_of(contact.port) + channel.substr(contact.port.size());
  };
  kind.port_of = [](const std::string& channel) { return contact_of(channel).value().port; };
  kind.number_of = [](const std::vector<std::string>&, std::size_t i) { return i; };
  kind.make = [](const std::vector<std::string>& channels,
                 const BuiltSource& source) -> std::shared_ptr<relay::RelaySense> {
    relay::ModemLineOptions options;
    options.sample_rate_hz = source.sample_rate_hz;
    for (const std::string& channel : channels) {
      options.contacts.push_back(contact_of(channel).value());
    }
    return std::make_shared<relay::ModemLineSense>(options, *source.source);
  };
  return kind;
}

}  // namespace gsbench::station

// Speed with a thousand outlets behind one MQTT broker: capacity of the broker, cost of the bench's
// link, and latency of a command compared with raw messages, all measured in one run. Exit code 1
// if a figure misses its limit.
#include "measuring.hpp"
#include "mqtt_peers.hpp"
#include <link_mqtt/mqtt_link.hpp>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <emulation/child.hpp>
#include <emulation/private_broker.hpp>
#include <link/wait_for_outlets.hpp>
#include <wire/codec.hpp>

namespace gsbench::performance {
namespace {

using emulation::Child;
using emulation::PrivateBroker;
using gs::wire::Downlink;
using gs::wire::DownlinkKind;
using gs::wire::UplinkKind;
using link::Happenings;
using link::MqttLink;
using link::Received;
using std::chrono::steady_clock;
using test::TemporaryFolder;

constexpr std::size_t kOutlets = 1000;
constexpr double kPerSecond = 62.5;
constexpr double kLoaded_s = 10.0;
constexpr std::size_t kSenders = 200;
constexpr std::size_t kFlatOut = 300;     // measurements per outlet to saturate the broker
constexpr double kShareOfCapacity = 0.7;  // leaves a margin for uneven arrival
constexpr auto kBetweenPolls = std::chrono::milliseconds(5);
constexpr int kRoundTrips = 200;
constexpr std::size_t kMessagesOfPrograms = 100000;

// User and system time of a process, s.
double processor_s(pid_t pid) {
  std::ifstream in("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  std::getline(in, text);
  std::istringstream fields(text.substr(text.rfind(')') + 2));
  std::string skipped;
  for (int i = 0; i < 11; ++i) {
    fields >> skipped;
  }
  double user = 0.0;
  double system = 0.0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

std::vector<std::string> some_ids(std::size_t count) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < count; ++i) {
    ids.push_back("outlet-" + std::to_string(i));
  }
  return ids;
}

// Starts all outlets in one process and waits until they are connected.
Child start_outlets(const PrivateBroker& broker, const std::vector<std::string>& ids,
                    std::size_t measurements, double per_second, const TemporaryFolder& folder) {
  std::string lines;
  for (const std::string& id : ids) {
    lines += id + ':' + broker.outlet(id).password + '\n';
  }
  const std::string output = folder.write("many-outlets.log", "");
  Child outlets = or_die(Child::start(
      {{std::string(GSBENCH_BINARY_DIR) + "/bin/many_outlets", broker.url(),
        broker.ca_file().empty() ? "-" : broker.ca_file(), folder.write("logins", lines),
        std::to_string(measurements), std::to_string(per_second)},
       output}));
  wait_for(
      [&] {
        std::string state;
        std::ifstream(output) >> state;
        return state == "connected";
      },
      "the outlets did not connect");
  return outlets;
}

Downlink ping(std::uint32_t token) {
  Downlink message;
  message.kind = DownlinkKind::kPing;
  message.token = token;
  return message;
}

// Encoded size of one measurement.
std::size_t measurement_bytes() {
  gs::wire::Uplink measurement;
  measurement.kind = UplinkKind::kMeasurement;
  std::uint8_t bytes[gs::wire::kLongestMessage];
  return gs::wire::encode(measurement, 0, bytes, sizeof bytes);
}

// ---- measurements

struct Capacity {
  double per_second = 0.0;            // at full speed, with all other load on this machine
  double per_processor_second = 0.0;  // per second of the broker's processor time
  double client_share = 0.0;          // processor time of the raw client / of the broker
};

Capacity measure_capacity(const PrivateBroker& broker, const TemporaryFolder& folder) {
  const auto ids = some_ids(kSenders);
  std::atomic<std::size_t> came{0};
  RawClient bench(broker, broker.bench(), "gs/+/up", [&](const mosquitto_message&) { ++came; });
  const Child outlets = start_outlets(broker, ids, kFlatOut, 0.0, folder);
  std::uint8_t bytes[gs::wire::kLongestMessage];
  const std::size_t size = gs::wire::encode(ping(0), 0, bytes, sizeof bytes);
  const double before = processor_s(broker.pid());
  const double client_before = own_processor_s();
  const auto begin = steady_clock::now();
  for (const std::string& id : ids) {
    bench.publish("gs/" + id + "/down", bytes, static_cast<int>(size));
  }
  const std::size_t all = kSenders * (kFlatOut + 1);  // including the answer to the ping
  wait_for([&] { return came >= all; }, "the broker lost messages");
  const double wall_s = seconds_since(begin);
  const double broker_s = processor_s(broker.pid()) - before;
  return {static_cast<double>(all) / wall_s, static_cast<double>(all) / broker_s,
          (own_processor_s() - client_before) / broker_s};
}

struct Carried {
  std::size_t outlets = 0;
  std::size_t sent = 0;
  std::size_t measurements = 0;
  std::size_t faults = 0;
  double wall_s = 0.0;
  double broker_s = 0.0;
  double bench_s = 0.0;
};

// Receives over the bench's link. `per_second`: rate of each outlet; 0 for full speed.
Carried carry(const PrivateBroker& broker, std::size_t count, std::size_t each, double per_second,
              const TemporaryFolder& folder) {
  const auto ids = some_ids(count);
  const Child outlets = start_outlets(broker, ids, each, per_second, folder);
  const link::MqttOptions options{
      broker.url(), broker.ca_file(), broker.bench().user, broker.bench().password, {}};
  MqttLink link(options);
  const auto opened = or_die(wait_for_outlets(link, ids, std::chrono::seconds(10)));
  if (std::any_of(opened.begin(), opened.end(),
                  [](const auto& outlet) { return !outlet.fault.empty(); })) {
    die("not all outlets were found");
  }

  Carried result{count, count * each};
  const double broker_before = processor_s(broker.pid());
  const double bench_before = own_processor_s();
  const auto begin = steady_clock::now();
  for (const std::string& id : ids) {
    or_die(link.send(id, ping(0)));
  }
  Happenings happenings;
  std::size_t other = 0;
  const auto all_came = [&] {
    happenings.messages.clear();
    or_die(link.poll(happenings));
    for (const Received& received : happenings.messages) {
      const bool measured = received.message.kind == UplinkKind::kMeasurement;
      result.measurements += measured ? 1 : 0;
      other += measured ? 0 : 1;
    }
    return result.measurements >= result.sent && other >= count;
  };
  comes_true(all_came, kBetweenPolls);  // missing messages are reported as lost
  result.wall_s = seconds_since(begin);
  result.broker_s = processor_s(broker.pid()) - broker_before;
  result.bench_s = own_processor_s() - bench_before;
  result.faults = happenings.faults.size();
  for (std::size_t i = 0; i < std::min<std::size_t>(happenings.faults.size(), 5); ++i) {
    std::printf("  %s: %s\n", happenings.faults[i].id.c_str(), happenings.faults[i].what.c_str());
  }
  return result;
}

double link_round_trip_ms(const PrivateBroker& broker, const TemporaryFolder& folder) {
  const Child outlets = start_outlets(broker, some_ids(1), 0, kPerSecond, folder);
  MqttLink link(
      {broker.url(), broker.ca_file(), broker.bench().user, broker.bench().password, some_ids(1)});
  or_die(wait_for_outlets(link, some_ids(1), std::chrono::seconds(10)));
  Happenings happenings;
  std::vector<double> taken;
  for (int i = 0; i < kRoundTrips; ++i) {
    happenings.messages.clear();
    const auto begin = steady_clock::now();
    or_die(link.send(some_ids(1).front(), ping(static_cast<std::uint32_t>(i))));
    wait_for(
        [&] {
          or_die(link.poll(happenings));
          return !happenings.messages.empty();
        },
        "a ping was not answered");
    taken.push_back(seconds_since(begin));
  }
  return 1000.0 * median(taken);
}

double raw_round_trip_ms(const PrivateBroker& broker) {
  std::atomic<int> answers{0};
  RawClient bench(broker, broker.bench(), "gs/outlet-0/up",
                  [&](const mosquitto_message&) { ++answers; });
  RawClient* answering = nullptr;
  RawClient outlet(broker, broker.outlet("outlet-0"), "gs/outlet-0/down",
                   [&](const mosquitto_message& message) {
                     answering->publish("gs/outlet-0/up", message.payload, message.payloadlen);
                   });
  answering = &outlet;
  std::vector<double> taken;
  for (int i = 0; i < kRoundTrips; ++i) {
    const auto begin = steady_clock::now();
    bench.publish("gs/outlet-0/down", &i, sizeof i);
    wait_for([&] { return answers > i; }, "a raw message was not answered");
    taken.push_back(seconds_since(begin));
  }
  return 1000.0 * median(taken);
}

int run() {
  mosquitto_lib_init();
  const TemporaryFolder folder;
  const PrivateBroker broker =
      or_die(PrivateBroker::start({folder.file("broker"), some_ids(kOutlets)}));

  const double raw_ms = raw_round_trip_ms(broker);
  const double link_ms = link_round_trip_ms(broker, folder);
  print("round trip of raw messages, acknowledged, over TLS", raw_ms, "ms");
  print("round trip of a ping to an outlet over the link", link_ms, "ms");

  const Capacity capacity = measure_capacity(broker, folder);
  print("the broker at full speed, 200 outlets to one raw client", capacity.per_second,
        "messages/s");
  print("  per second of its processor time", capacity.per_processor_second, "messages/s");
  print("  processor time, raw client / broker", capacity.client_share, "");
  print("the same from mosquitto_pub to mosquitto_sub, one of each",
        programs_per_second(broker, "outlet-0", kMessagesOfPrograms, measurement_bytes(), folder),
        "messages/s");
  const auto carried_outlets = std::min(
      kOutlets, static_cast<std::size_t>(kShareOfCapacity * capacity.per_second / kPerSecond));

  const Carried full_speed = carry(broker, kSenders, kFlatOut, 0.0, folder);
  print("the same at full speed over the link",
        static_cast<double>(full_speed.measurements) / full_speed.wall_s, "messages/s");
  print("  measurements lost", static_cast<double>(full_speed.sent - full_speed.measurements), "");
  print("  processor time, bench / broker", full_speed.bench_s / full_speed.broker_s, "");

  const Carried carried =
      carry(broker, carried_outlets, static_cast<std::size_t>(kPerSecond * kLoaded_s), kPerSecond,
            folder);
  print("outlets at 62.5 measurements/s each", static_cast<double>(carried.outlets), "");
  print("  measurements received", static_cast<double>(carried.measurements), "");
  print("  per second", static_cast<double>(carried.measurements) / carried.wall_s, "messages/s");
  print("  processor time of the broker", carried.broker_s, "s");
  print("  processor time of the bench", carried.bench_s, "s");
  judge_at_most("  measurements lost", static_cast<double>(carried.sent - carried.measurements), "",
                0.0);
  judge_at_most("  faults reported", static_cast<double>(carried.faults), "", 0.0);
  print("  processor time, bench / broker", carried.bench_s / carried.broker_s, "");
  return exit_code();
}

}  // namespace
}  // namespace gsbench::performance

int main() {
  return gsbench::performance::run();
}

// A thousand outlets behind one broker: what the broker itself carries, what the bench's link costs
// beside it, and how long a command takes beside raw messages, all measured in one run. Exits with
// 1 where a figure falls short.
#include <link_mqtt/mqtt_link.hpp>
#include <mosquitto.h>
#include <mqtt_protocol.h>
#include <sys/resource.h>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <broker/private_broker.hpp>
#include <process/child.hpp>
#include <wire/codec.hpp>

namespace {

using gs::wire::Downlink;
using gs::wire::DownlinkKind;
using gs::wire::UplinkKind;
using gsbench::broker::Login;
using gsbench::broker::PrivateBroker;
using gsbench::link::Fault;
using gsbench::link::MqttLink;
using gsbench::link::MqttOptions;
using gsbench::link::Received;
using gsbench::process::Child;
using gsbench::test::TemporaryFolder;
using std::chrono::steady_clock;

constexpr std::size_t kOutlets = 1000;
constexpr double kPerSecond = 62.5;
constexpr double kLoadedS = 10.0;
constexpr std::size_t kSenders = 200;
constexpr std::size_t kFlatOut = 300;     // measurements of each outlet to saturate the broker
constexpr double kShareOfCapacity = 0.7;  // what is left over takes its uneven arrival
constexpr int kRoundTrips = 200;
constexpr auto kPatience = std::chrono::seconds(60);

template <class T>
T or_die(gsbench::drivers::Result<T> result) {
  if (!result.ok()) {
    std::fprintf(stderr, "%s\n", result.error().c_str());
    std::exit(1);
  }
  return result.take();
}

bool wait_for(const std::function<bool()>& condition,
              std::chrono::microseconds pause = std::chrono::milliseconds(5)) {
  const auto until = steady_clock::now() + kPatience;
  while (!condition()) {
    if (steady_clock::now() > until) {
      return false;
    }
    std::this_thread::sleep_for(pause);
  }
  return true;
}

void demand(bool met, const char* what) {
  if (!met) {
    std::fprintf(stderr, "%s\n", what);
    std::exit(1);
  }
}

// User and system time.
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

double own_processor_s() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

double seconds_since(steady_clock::time_point begin) {
  return std::chrono::duration<double>(steady_clock::now() - begin).count();
}

std::vector<std::string> some_ids(std::size_t count) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < count; ++i) {
    ids.push_back("outlet-" + std::to_string(i));
  }
  return ids;
}

// All outlets in one process, connected when this returns.
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
  demand(wait_for([&] {
           std::string word;
           std::ifstream(output) >> word;
           return word == "connected";
         }),
         "the outlets did not connect");
  return outlets;
}

Downlink ping(std::uint32_t token) {
  Downlink message;
  message.kind = DownlinkKind::kPing;
  message.token = token;
  return message;
}

// ---- raw clients of libmosquitto, one thread each

class RawClient {
 public:
  using OnMessage = std::function<void(const mosquitto_message&)>;

  RawClient(const PrivateBroker& broker, const Login& login, const std::string& topic,
            OnMessage on_message)
      : on_message_(std::move(on_message)),
        topic_(topic),
        client_(mosquitto_new(nullptr, true, this)) {
    mosquitto_int_option(client_, MOSQ_OPT_PROTOCOL_VERSION, MQTT_PROTOCOL_V5);
    mosquitto_int_option(client_, MOSQ_OPT_TCP_NODELAY, 1);
    mosquitto_username_pw_set(client_, login.user.c_str(), login.password.c_str());
    mosquitto_tls_set(client_, broker.ca_file().c_str(), nullptr, nullptr, nullptr, nullptr);
    mosquitto_connect_callback_set(client_, [](mosquitto* client, void* self, int) {
      mosquitto_subscribe(client, nullptr, static_cast<RawClient*>(self)->topic_.c_str(), 1);
    });
    mosquitto_subscribe_callback_set(client_, [](mosquitto*, void* self, int, int, const int*) {
      static_cast<RawClient*>(self)->subscribed_ = true;
    });
    mosquitto_message_callback_set(client_,
                                   [](mosquitto*, void* self, const mosquitto_message* message) {
                                     static_cast<RawClient*>(self)->on_message_(*message);
                                   });
    mosquitto_connect(client_, "127.0.0.1", broker.port(), 30);
    mosquitto_loop_start(client_);
    demand(wait_for([this] { return subscribed_.load(); }), "a raw client did not connect");
  }
  ~RawClient() {
    mosquitto_disconnect(client_);
    mosquitto_loop_stop(client_, false);
    mosquitto_destroy(client_);
  }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  void publish(const std::string& topic, const void* bytes, int size) {
    mosquitto_publish(client_, nullptr, topic.c_str(), size, bytes, 1, false);
  }

 private:
  OnMessage on_message_;
  std::string topic_;
  std::atomic<bool> subscribed_{false};
  mosquitto* client_;
};

// ---- what is measured

struct Capacity {
  double per_second = 0.0;            // flat out, on this machine with all it does beside
  double per_processor_second = 0.0;  // of the broker's alone
  double client_share = 0.0;          // the raw client's processor time by the broker's
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
  const std::size_t all = kSenders * (kFlatOut + 1);  // the answer to the ping, too
  demand(wait_for([&] { return came >= all; }), "the broker lost messages");
  const double wall_s = seconds_since(begin);
  const double broker_s = processor_s(broker.pid()) - before;
  return {static_cast<double>(all) / wall_s, static_cast<double>(all) / broker_s,
          (own_processor_s() - client_before) / broker_s};
}

struct Carried {
  std::size_t outlets = 0;
  std::size_t said = 0;
  std::size_t measurements = 0;
  std::size_t faults = 0;
  double wall_s = 0.0;
  double broker_s = 0.0;
  double bench_s = 0.0;
};

// Over the bench's link. `per_second`: 0 for flat out.
Carried carry(const PrivateBroker& broker, std::size_t count, std::size_t each, double per_second,
              const TemporaryFolder& folder) {
  const auto ids = some_ids(count);
  const Child outlets = start_outlets(broker, ids, each, per_second, folder);
  MqttOptions options{
      broker.url(), broker.ca_file(), broker.bench().user, broker.bench().password, {}};
  options.search = std::chrono::seconds(3);
  MqttLink link(options);
  const auto opened = or_die(link.open());
  demand(opened.size() == count, "not all outlets were found");

  Carried result{count, count * each};
  const double broker_before = processor_s(broker.pid());
  const double bench_before = own_processor_s();
  const auto begin = steady_clock::now();
  for (std::size_t i = 0; i < count; ++i) {
    or_die(link.send(i, ping(0)));
  }
  std::vector<Received> messages;
  std::vector<Fault> faults;
  std::size_t other = 0;
  wait_for([&] {
    messages.clear();
    or_die(link.poll(messages, faults));
    for (const Received& received : messages) {
      const bool measured = received.message.kind == UplinkKind::kMeasurement;
      result.measurements += measured ? 1 : 0;
      other += measured ? 0 : 1;
    }
    return result.measurements >= result.said && other >= count;
  });
  result.wall_s = seconds_since(begin);
  result.broker_s = processor_s(broker.pid()) - broker_before;
  result.bench_s = own_processor_s() - bench_before;
  result.faults = faults.size();
  for (std::size_t i = 0; i < std::min<std::size_t>(faults.size(), 5); ++i) {
    std::printf("  %s: %s\n", ids[faults[i].outlet].c_str(), faults[i].what.c_str());
  }
  return result;
}

double median_ms(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return 1000.0 * seconds[seconds.size() / 2];
}

double link_round_trip_ms(const PrivateBroker& broker, const TemporaryFolder& folder) {
  const Child outlets = start_outlets(broker, some_ids(1), 0, kPerSecond, folder);
  MqttLink link(
      {broker.url(), broker.ca_file(), broker.bench().user, broker.bench().password, some_ids(1)});
  or_die(link.open());
  std::vector<Received> messages;
  std::vector<Fault> faults;
  std::vector<double> taken;
  for (int i = 0; i < kRoundTrips; ++i) {
    messages.clear();
    const auto begin = steady_clock::now();
    or_die(link.send(0, ping(static_cast<std::uint32_t>(i))));
    demand(wait_for(
               [&] {
                 or_die(link.poll(messages, faults));
                 return !messages.empty();
               },
               std::chrono::microseconds(20)),
           "a ping was not answered");
    taken.push_back(seconds_since(begin));
  }
  return median_ms(taken);
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
    demand(wait_for([&] { return answers > i; }, std::chrono::microseconds(20)),
           "a raw message was not answered");
    taken.push_back(seconds_since(begin));
  }
  return median_ms(taken);
}

bool short_of = false;

void print(const char* what, double value, const char* unit) {
  std::printf("%-62s %10.3f %s\n", what, value, unit);
}

void judge(const char* what, double value, const char* unit, double most) {
  const bool reached = value <= most;
  short_of = short_of || !reached;
  std::printf("%-62s %10.3f %-10s wanted at most %g: %s\n", what, value, unit, most,
              reached ? "reached" : "FALLS SHORT");
}

}  // namespace

int main() {
  mosquitto_lib_init();
  const TemporaryFolder folder;
  const PrivateBroker broker =
      or_die(PrivateBroker::start({folder.file("broker"), some_ids(kOutlets)}));

  const double raw_ms = raw_round_trip_ms(broker);
  const double link_ms = link_round_trip_ms(broker, folder);
  print("round trip of raw messages, acknowledged, over TLS", raw_ms, "ms");
  print("round trip of a ping to an outlet over the link", link_ms, "ms");

  const Capacity capacity = measure_capacity(broker, folder);
  print("the broker flat out, 200 outlets to one raw client", capacity.per_second, "messages/s");
  print("  of its own processor time", capacity.per_processor_second, "messages/s");
  print("  the raw client's processor time by the broker's", capacity.client_share, "");
  const auto carried_outlets = std::min(
      kOutlets, static_cast<std::size_t>(kShareOfCapacity * capacity.per_second / kPerSecond));

  const Carried flat_out = carry(broker, kSenders, kFlatOut, 0.0, folder);
  print("the same flat out to the link",
        static_cast<double>(flat_out.measurements) / flat_out.wall_s, "messages/s");
  print("  measurements lost", static_cast<double>(flat_out.said - flat_out.measurements), "");
  print("  the bench's processor time by the broker's", flat_out.bench_s / flat_out.broker_s, "");

  const Carried carried = carry(
      broker, carried_outlets, static_cast<std::size_t>(kPerSecond * kLoadedS), kPerSecond, folder);
  print("outlets at 62.5 measurements/s each", static_cast<double>(carried.outlets), "");
  print("  measurements received", static_cast<double>(carried.measurements), "");
  print("  per second", static_cast<double>(carried.measurements) / carried.wall_s, "messages/s");
  print("  processor time of the broker", carried.broker_s, "s");
  print("  processor time of the bench", carried.bench_s, "s");
  judge("  measurements lost", static_cast<double>(carried.said - carried.measurements), "", 0.0);
  judge("  faults told", static_cast<double>(carried.faults), "", 0.0);
  judge("  the bench's time by the broker's", carried.bench_s / carried.broker_s, "", 0.5);
  return short_of ? 1 : 0;
}

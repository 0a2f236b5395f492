// A load generator: many outlets on one broker, each on its own connection, all in one thread.
//   many_outlets URL CA-FILE LOGINS MEASUREMENTS PER-SECOND
// LOGINS has a line id:password for each outlet; CA-FILE is '-' without TLS. Prints "connected"
// once all outlets are connected. From its first ping on, each outlet sends MEASUREMENTS
// measurements at PER-SECOND (0: as fast as possible); other messages are answered as usual.
// Outlets process no samples: the firmware's arithmetic for a thousand outlets would dominate the
// load.
#include <mqtt_carrier.hpp>
#include <sys/epoll.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <app/endpoint.hpp>
#include <wire/codec.hpp>

namespace {

using std::chrono::steady_clock;
using Duration = steady_clock::duration;

constexpr std::size_t kConnectingAtOnce = 32;
constexpr int kBurst = 50;  // most measurements of one outlet in a row

struct Load {
  std::uint64_t measurements = 0;
  Duration between{};
};

class Outlet {
 public:
  Outlet(const gs::host::MqttOptions& options, const Load& load)
      : load_(load), endpoint_(app_, carrier_) {
    gs::app::Identity identity;
    gs::app::set_text(identity.id, options.id.c_str());
    gs::app::set_text(identity.board, "many-outlets");
    identity.instance = options.instance;
    std::string why;
    if (!carrier_.start(options, why)) {
      std::fprintf(stderr, "%s: %s\n", options.id.c_str(), why.c_str());
      std::exit(1);
    }
    app_.start({}, identity, nullptr, endpoint_);
  }

  void serve() {
    carrier_.serve();
    if (carrier_.take_reconnected()) {
      app_.receive(gs::wire::identify(), endpoint_);
    }
    while (carrier_.take(message_)) {
      gs::wire::Downlink read;
      std::uint32_t sequence = 0;
      if (started_ == steady_clock::time_point() &&
          gs::wire::decode(message_.data(), message_.size(), read, sequence) ==
              gs::wire::Decoded::kOk &&
          read.kind == gs::wire::DownlinkKind::kPing) {
        started_ = steady_clock::now();
      }
      endpoint_.receive(message_.data(), message_.size());
    }
  }

  void measure(steady_clock::time_point now) {
    if (started_ == steady_clock::time_point()) {
      return;
    }
    for (int i = 0; i < kBurst && sent_ < load_.measurements; ++i) {
      if (now < started_ + load_.between * static_cast<Duration::rep>(sent_)) {
        return;
      }
      gs::wire::Uplink measurement;
      measurement.kind = gs::wire::UplinkKind::kMeasurement;
      measurement.sample = 128 * ++sent_;
      measurement.measurement = {49.98F, -0.01F, 1.0F, gs::outlet::Validity::kValid};
      endpoint_.put(measurement);
    }
  }

  const gs::host::MqttCarrier& carrier() const { return carrier_; }

 private:
  const Load& load_;
  gs::host::MqttCarrier carrier_;
  gs::app::Application app_;
  gs::app::MessageEndpoint endpoint_;
  steady_clock::time_point started_;
  std::uint64_t sent_ = 0;
  std::vector<std::uint8_t> message_;
};

std::vector<gs::host::MqttOptions> read_logins(const char* file, const std::string& url,
                                               const std::string& ca_file) {
  std::vector<gs::host::MqttOptions> all;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(':');
    const std::string id = line.substr(0, colon);
    all.push_back(
        {url, ca_file, id, line.substr(colon + 1), id, static_cast<std::uint32_t>(all.size())});
  }
  return all;
}

void allow_many_connections() {
  rlimit files{};
  getrlimit(RLIMIT_NOFILE, &files);
  files.rlim_cur = files.rlim_max;
  setrlimit(RLIMIT_NOFILE, &files);
}

void connect(const std::vector<gs::host::MqttOptions>& logins, const Load& load, int ready,
             std::vector<std::unique_ptr<Outlet>>& outlets) {
  std::size_t connected = 0;
  while (connected < logins.size()) {
    while (outlets.size() < logins.size() && outlets.size() < connected + kConnectingAtOnce) {
      outlets.push_back(std::make_unique<Outlet>(logins[outlets.size()], load));
    }
    for (std::size_t i = connected; i < outlets.size(); ++i) {
      outlets[i]->serve();
    }
    while (connected < outlets.size() && outlets[connected]->carrier().connected()) {
      epoll_event event{};
      event.events = EPOLLIN;
      event.data.ptr = outlets[connected].get();
      epoll_ctl(ready, EPOLL_CTL_ADD, outlets[connected]->carrier().descriptor(), &event);
      ++connected;
    }
    usleep(500);
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 6) {
    std::fprintf(stderr, "usage: many_outlets URL CA-FILE|- LOGINS MEASUREMENTS PER-SECOND\n");
    return 2;
  }
  const std::string ca_file = words[2][0] == '-' ? "" : words[2];
  const double per_second = std::strtod(words[5], nullptr);
  Load load;
  load.measurements = std::strtoull(words[4], nullptr, 10);
  if (per_second > 0.0) {
    load.between =
        std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1.0 / per_second));
  }
  allow_many_connections();
  const int ready = epoll_create1(EPOLL_CLOEXEC);
  std::vector<std::unique_ptr<Outlet>> outlets;
  connect(read_logins(words[3], words[1], ca_file), load, ready, outlets);
  std::printf("connected\n");
  std::fflush(stdout);

  // Runs until it is killed.
  std::vector<epoll_event> events(outlets.size());
  for (auto upkeep = steady_clock::now();;) {
    const int some = epoll_wait(ready, events.data(), static_cast<int>(events.size()), 1);
    for (int i = 0; i < some; ++i) {
      static_cast<Outlet*>(events[static_cast<std::size_t>(i)].data.ptr)->serve();
    }
    const auto now = steady_clock::now();
    const bool all = now >= upkeep;
    for (const auto& outlet : outlets) {
      if (all || outlet->carrier().wants_to_write()) {
        outlet->serve();
      }
      outlet->measure(now);
    }
    if (all) {
      upkeep = now + std::chrono::milliseconds(100);
    }
  }
}

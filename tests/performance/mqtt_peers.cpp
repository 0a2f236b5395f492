#include "mqtt_peers.hpp"

#include "measuring.hpp"
#include <mqtt_protocol.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include <emulation/child.hpp>

namespace gsbench::performance {

using emulation::Child;
using emulation::Login;
using emulation::PrivateBroker;

RawClient::RawClient(const PrivateBroker& broker, const Login& login, const std::string& topic,
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
  wait_for([this] { return subscribed_.load(); }, "a raw client did not connect");
}

RawClient::~RawClient() {
  mosquitto_disconnect(client_);
  mosquitto_loop_stop(client_, false);
  mosquitto_destroy(client_);
}

void RawClient::publish(const std::string& topic, const void* bytes, int size) {
  mosquitto_publish(client_, nullptr, topic.c_str(), size, bytes, 1, false);
}

namespace {

std::vector<std::string> arguments_of(const char* program, const PrivateBroker& broker,
                                      const Login& login, const std::string& topic) {
  const std::string port = std::to_string(broker.port());
  return {program,    "-V", "mqttv5",       "-h",       "127.0.0.1",      "-p", port, "-u",
          login.user, "-P", login.password, "--cafile", broker.ca_file(), "-t", topic};
}

}  // namespace

double programs_per_second(const PrivateBroker& broker, const std::string& outlet,
                           std::size_t messages, std::size_t size,
                           const test::TemporaryFolder& folder) {
  const std::string topic = "gs/" + outlet + "/up";
  // An additional retained message shows that the subscription is active.
  const std::string hello = "gs/" + outlet + "/hello";
  auto announce = arguments_of("mosquitto_pub", broker, broker.outlet(outlet), hello);
  announce.insert(announce.end(), {"-r", "-m", "here"});
  Child announcer = or_die(Child::start({announce, ""}));
  wait_for([&] { return !announcer.running(); }, "mosquitto_pub did not end");

  const std::string received = folder.file("received");
  auto receive = arguments_of("mosquitto_sub", broker, broker.bench(), topic);
  receive.insert(receive.end(), {"-t", hello, "-C", std::to_string(messages + 1)});
  Child receiver = or_die(Child::start({receive, received}));
  wait_for(
      [&] { return std::filesystem::exists(received) && std::filesystem::file_size(received) > 0; },
      "mosquitto_sub did not connect");

  const std::string lines = folder.file("lines");
  {
    std::ofstream out(lines);
    for (std::size_t i = 0; i < messages; ++i) {
      out << std::string(size, 'm') << '\n';
    }
  }
  const auto send = arguments_of("mosquitto_pub", broker, broker.outlet(outlet), topic);
  std::string command = "exec";
  for (const std::string& argument : send) {
    command += " '" + argument + '\'';
  }
  const auto begin = std::chrono::steady_clock::now();
  const Child sender = or_die(Child::start({{"sh", "-c", command + " -l <'" + lines + '\''}, ""}));
  wait_for([&] { return !receiver.running(); }, "mosquitto_sub did not receive all messages");
  return static_cast<double>(messages) / seconds_since(begin);
}

}  // namespace gsbench::performance

#include "rigs.hpp"
#include <link_mqtt/mqtt_link.hpp>

namespace gsbench::test {
namespace {

class MqttRig final : public ProcessRig {
 public:
  MqttRig() : ProcessRig(emulation::Connection::kMqtt) {}

  std::shared_ptr<link::Link> make_link() override {
    const emulation::PrivateBroker& broker = *outlets.hardware().broker();
    link::MqttOptions options;
    options.url = broker.url();
    options.ca_file = broker.ca_file();
    options.user = broker.bench().user;
    options.password = broker.bench().password;
    options.outlets = {kA, kB};
    return std::make_shared<link::MqttLink>(options);
  }
  void unplug() override { outlets.kill(kA); }
  void plug_in() override { outlets.start(kA); }
  Words words() const override {
    return {"is not on the broker", "left the broker",
            "was not sent a message: it is not on the broker", "restarted after its sample "};
  }
};

}  // namespace

std::unique_ptr<LinkRig> mqtt_rig() {
  return std::make_unique<MqttRig>();
}

}  // namespace gsbench::test

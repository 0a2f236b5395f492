#include "rigs.hpp"
#include <link_test/bench_options.hpp>

namespace gsbench::test {
namespace {

class MqttRig final : public ProcessRig {
 public:
  MqttRig() : ProcessRig(emulation::Connection::kMqtt) {}

  std::shared_ptr<link::Link> make_link() override {
    return std::make_shared<link::MqttLink>(bench_options(*outlets.hardware().broker(), {kA, kB}));
  }
  void unplug() override { outlets.kill(kA); }
  void plug_in() override { outlets.start(kA); }
  FaultTexts fault_texts() const override {
    return {"is not on the broker", "left the broker",
            "was not sent a message: it is not on the broker"};
  }
};

}  // namespace

std::unique_ptr<LinkRig> mqtt_rig() {
  return std::make_unique<MqttRig>();
}

}  // namespace gsbench::test

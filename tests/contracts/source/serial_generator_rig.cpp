// A generator on a serial line, for the conformance suite.
#include "generator_rig.hpp"
#include "serial_adapter.hpp"

namespace gsbench::test {
namespace {

class SerialGeneratorRig final : public GeneratorRig {
 public:
  SerialGeneratorRig() : GeneratorRig(kGeneratorCases[1]), adapter_(options.port) {
    options.port = adapter_.port();
  }

  void unplug() override {
    GeneratorRig::unplug();
    adapter_.wait_for_port(false);
  }
  void plug_in() override {
    GeneratorRig::plug_in();
    adapter_.wait_for_port(true);
  }
  void become_another_model() override {
    const int plugs = adapter_.plugs();
    GeneratorRig::become_another_model();
    adapter_.wait_for_more_plugs_than(plugs);
  }

 private:
  SerialAdapter adapter_;
};

}  // namespace

std::unique_ptr<InstrumentRig> serial_sdg2042x() {
  return std::make_unique<SerialGeneratorRig>();
}

}  // namespace gsbench::test

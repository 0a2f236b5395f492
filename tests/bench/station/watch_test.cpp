// Which messages of an outlet belong to its run.
#include "watch.hpp"

#include <vector>

#include <gmock/gmock.h>

namespace gsbench::station::test {
namespace {

using ::testing::ElementsAre;

class RunningOutlet : public testing::Test {
 protected:
  static std::vector<record::OutletRecord> one_outlet() {
    record::OutletRecord outlet;
    outlet.id = "a";
    outlet.link = "serial";
    outlet.took_part = true;
    return {outlet};
  }

  static link::Received message(std::uint64_t sample, std::uint32_t start_number) {
    link::Received received;
    received.id = "a";
    received.message.kind = gs::wire::UplinkKind::kMeasurement;
    received.message.sample = sample;
    received.message.start_number = start_number;
    return received;
  }

  // The samples of the messages that are kept.
  std::vector<std::uint64_t> kept(const std::vector<link::Received>& messages) {
    link::Happenings happenings;
    happenings.messages = messages;
    watch_.process(happenings, 0);
    std::vector<std::uint64_t> samples;
    for (const link::Received& received : happenings.messages) {
      samples.push_back(received.message.sample);
    }
    return samples;
  }

  std::vector<record::OutletRecord> outlets_ = one_outlet();
  Watch watch_{outlets_, 8000};
};

TEST_F(RunningOutlet, MayStampAMessageBeforeAnEarlierOne) {
  EXPECT_THAT(kept({message(256, 7), message(250, 7), message(384, 7)}),
              ElementsAre(256, 250, 384));
}

TEST_F(RunningOutlet, IsNotHeardAfterItsRestart) {
  EXPECT_THAT(kept({message(256, 7), message(300, 8), message(384, 7)}), ElementsAre(256));
  EXPECT_THAT(kept({message(512, 7)}), ElementsAre());
}

}  // namespace
}  // namespace gsbench::station::test

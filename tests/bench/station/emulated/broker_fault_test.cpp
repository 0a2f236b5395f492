// Failures of the MQTT broker during a run.
#include "station_of_four.hpp"

namespace gsbench::station::test {
namespace {

using BrokerFault = FaultyStation;

TEST_F(BrokerFault, RestartIsReportedForOutletsBehindItOnly) {
  at(0.45, [&] { hardware().broker()->kill(); });
  at(0.55, [&] { ASSERT_TRUE(hardware().broker()->restart().ok()); });
  play();
  expect_faults({{kRadioA, "lost its broker"}, {kRadioB, "lost its broker"}});
}

TEST_F(BrokerFault, LossIsReportedForOutletsBehindItOnly) {
  at(0.45, [&] { hardware().broker()->kill(); });
  play();
  expect_faults({{kRadioA, "lost its broker"}, {kRadioB, "lost its broker"}});
}

TEST_F(BrokerFault, BeforeTheRunIsReportedInTime) {
  hardware().broker()->kill();
  play();
  EXPECT_EQ(record_.verdict, record::Verdict::kError);
  EXPECT_THAT(record_.verdict_reason, testing::HasSubstr("broker"));
}

}  // namespace
}  // namespace gsbench::station::test

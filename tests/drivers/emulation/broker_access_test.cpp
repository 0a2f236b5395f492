// The private broker's access rules, tested with Mosquitto's command-line clients. Each refused
// attempt is compared with the same attempt with the right credentials.
#include "broker_client.hpp"
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>

#include <gtest/gtest.h>

namespace gsbench::test {
namespace {

using emulation::PrivateBroker;

class BrokerAccess : public testing::Test {
 protected:
  BrokerClient bench() const { return {broker_, broker_.ca_file(), broker_.bench()}; }
  BrokerClient outlet(const std::string& id) const {
    return {broker_, broker_.ca_file(), broker_.outlet(id)};
  }

  TemporaryFolder folder_;
  PrivateBroker broker_ = demand(PrivateBroker::start({folder_.file("broker"), {"a", "b"}}));
};

TEST_F(BrokerAccess, OnlyTheBenchReadsAnOutletsMessages) {
  outlet("a").write("gs/a/hello", "I am a");
  outlet("a").write("gs/a/up", "50 Hz");
  EXPECT_EQ(bench().read("gs/a/hello"), "I am a");
  EXPECT_EQ(bench().read("gs/a/up"), "50 Hz");
  EXPECT_EQ(outlet("b").read("gs/a/#"), "");
}

TEST_F(BrokerAccess, OnlyTheBenchCommandsAnOutlet) {
  outlet("b").write("gs/a/down", "open, from b");
  EXPECT_EQ(outlet("a").read("gs/a/down"), "");
  bench().write("gs/a/down", "open");
  EXPECT_EQ(outlet("a").read("gs/a/down"), "open");
  EXPECT_EQ(outlet("b").read("gs/a/down"), "");
}

TEST_F(BrokerAccess, AnOutletCannotPublishUnderAnotherId) {
  outlet("b").write("gs/a/hello", "I am a, from b");
  EXPECT_EQ(bench().read("gs/a/hello"), "");
  outlet("b").write("gs/b/hello", "I am b");
  EXPECT_EQ(bench().read("gs/+/hello"), "I am b");
}

TEST_F(BrokerAccess, RequiresTheRightPassword) {
  outlet("a").write("gs/a/hello", "I am a");
  const BrokerClient without{broker_, broker_.ca_file(), {}};
  const BrokerClient wrong{broker_, broker_.ca_file(), {"bench", "guessed"}};
  for (const BrokerClient& client : {without, wrong}) {
    EXPECT_EQ(client.read("gs/a/hello"), "");
    client.write("gs/a/down", "open");
  }
  EXPECT_EQ(outlet("a").read("gs/a/down"), "");
  EXPECT_EQ(bench().read("gs/a/hello"), "I am a");
}

TEST_F(BrokerAccess, RequiresTlsWithItsOwnCa) {
  outlet("a").write("gs/a/hello", "I am a");
  const PrivateBroker other = demand(PrivateBroker::start({folder_.file("other"), {}}));
  const BrokerClient no_tls{broker_, "", broker_.bench()};
  const BrokerClient wrong_ca{broker_, other.ca_file(), broker_.bench()};
  EXPECT_EQ(no_tls.read("gs/a/hello"), "");
  EXPECT_EQ(wrong_ca.read("gs/a/hello"), "");
  EXPECT_EQ(bench().read("gs/a/hello"), "I am a");
}

}  // namespace
}  // namespace gsbench::test

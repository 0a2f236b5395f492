#include "broker_client.hpp"
#include <sys/stat.h>
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using emulation::PrivateBroker;
using testing::HasSubstr;

TEST(PrivateBroker, KeepsItsFolderAndPasswordsPrivate) {
  const TemporaryFolder folder;
  const PrivateBroker broker = demand(PrivateBroker::start({folder.file("broker"), {"a"}}));
  struct stat status {};
  ASSERT_EQ(stat(folder.file("broker").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0700U);
  // The folder holds neither a plain password nor the CA's key.
  const std::string passwords = folder.read("broker/passwords");
  EXPECT_THAT(passwords, HasSubstr("bench:$7$"));
  EXPECT_EQ(passwords.find(broker.bench().password), std::string::npos);
  const auto entries = folder.entries();
  EXPECT_EQ(std::count(entries.begin(), entries.end(), "broker/ca.key"), 0);
  EXPECT_EQ(std::count(entries.begin(), entries.end(), "broker/ca.pem"), 1);
}

TEST(PrivateBroker, RestartsOnItsPortAfterAKill) {
  const TemporaryFolder folder;
  PrivateBroker broker = demand(PrivateBroker::start({folder.file("broker"), {"a"}}));
  const auto port = broker.port();
  const auto first = broker.pid();
  const BrokerClient a{broker, broker.ca_file(), broker.outlet("a")};
  const BrokerClient bench{broker, broker.ca_file(), broker.bench()};
  broker.kill();
  EXPECT_FALSE(broker.running());
  demand(broker.restart());
  EXPECT_TRUE(broker.running());
  EXPECT_EQ(broker.port(), port);
  EXPECT_NE(broker.pid(), first);
  a.write("gs/a/hello", "back");
  EXPECT_EQ(bench.read("gs/a/hello"), "back");
}

TEST(PrivateBroker, SeveralRunAtOnce) {
  const TemporaryFolder folder;
  const PrivateBroker one = demand(PrivateBroker::start({folder.file("one"), {}}));
  const PrivateBroker two = demand(PrivateBroker::start({folder.file("two"), {}}));
  EXPECT_NE(one.port(), two.port());
  EXPECT_NE(one.bench().password, two.bench().password);
}

TEST(PrivateBroker, RefusesIdsThatItsAccessListWouldMisread) {
  const TemporaryFolder folder;
  for (const char* id : {"", "+", "a/b", "a:b", "a b", "bench", "#"}) {
    const auto started = PrivateBroker::start({folder.file("broker"), {id}});
    ASSERT_FALSE(started.ok()) << id;
    EXPECT_THAT(started.error(), HasSubstr('"' + std::string(id) + '"'));
  }
}

TEST(PrivateBroker, ReportsWhyItCannotStart) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  const auto started = PrivateBroker::start({file + "/broker", {}});
  ASSERT_FALSE(started.ok());
  EXPECT_THAT(started.error(), HasSubstr(file));
}

}  // namespace
}  // namespace gsbench::test

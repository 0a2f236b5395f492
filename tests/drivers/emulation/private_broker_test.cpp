#include "outsider.hpp"
#include <sys/stat.h>
#include <test_support/temporary_folder.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using gsbench::emulation::PrivateBroker;
using gsbench::test::Outsider;
using gsbench::test::TemporaryFolder;
using testing::HasSubstr;

std::string content(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(PrivateBroker, KeepsItsFolderToItself) {
  const TemporaryFolder folder;
  auto started = PrivateBroker::start({folder.file("broker"), {"a"}});
  ASSERT_TRUE(started.ok()) << started.error();
  struct stat status {};
  ASSERT_EQ(stat(folder.file("broker").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0700U);
  // Neither a password in clear nor what could sign another certificate is left in it.
  const std::string passwords = content(folder.file("broker/passwords"));
  EXPECT_THAT(passwords, HasSubstr("bench:$7$"));
  EXPECT_EQ(passwords.find(started.value().bench().password), std::string::npos);
  const auto entries = folder.entries();
  EXPECT_EQ(std::count(entries.begin(), entries.end(), "broker/ca.key"), 0);
  EXPECT_EQ(std::count(entries.begin(), entries.end(), "broker/ca.pem"), 1);
}

TEST(PrivateBroker, ComesBackOnItsPortAfterAKill) {
  const TemporaryFolder folder;
  auto started = PrivateBroker::start({folder.file("broker"), {"a"}});
  ASSERT_TRUE(started.ok()) << started.error();
  PrivateBroker broker = started.take();
  const auto port = broker.port();
  const auto first = broker.pid();
  const Outsider a{broker, broker.ca_file(), broker.outlet("a")};
  const Outsider bench{broker, broker.ca_file(), broker.bench()};
  broker.kill();
  EXPECT_FALSE(broker.running());
  const auto restarted = broker.restart();
  ASSERT_TRUE(restarted.ok()) << restarted.error();
  EXPECT_TRUE(broker.running());
  EXPECT_EQ(broker.port(), port);
  EXPECT_NE(broker.pid(), first);
  a.write("gs/a/hello", "back");
  EXPECT_EQ(bench.read("gs/a/hello"), "back");
}

TEST(PrivateBroker, ManyStandBesideEachOther) {
  const TemporaryFolder folder;
  auto one = PrivateBroker::start({folder.file("one"), {}});
  auto two = PrivateBroker::start({folder.file("two"), {}});
  ASSERT_TRUE(one.ok()) << one.error();
  ASSERT_TRUE(two.ok()) << two.error();
  EXPECT_NE(one.value().port(), two.value().port());
  EXPECT_NE(one.value().bench().password, two.value().bench().password);
}

TEST(PrivateBroker, RefusesIdsThatItsAccessListWouldMisread) {
  const TemporaryFolder folder;
  for (const char* id : {"", "+", "a/b", "a:b", "a b", "bench", "#"}) {
    const auto started = PrivateBroker::start({folder.file("broker"), {id}});
    ASSERT_FALSE(started.ok()) << id;
    EXPECT_THAT(started.error(), HasSubstr('"' + std::string(id) + '"'));
  }
}

TEST(PrivateBroker, SaysWhyItCannotStart) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file", "");
  const auto started = PrivateBroker::start({file + "/broker", {}});
  ASSERT_FALSE(started.ok());
  EXPECT_THAT(started.error(), HasSubstr(file));
}

}  // namespace

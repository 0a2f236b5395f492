// Outlets that come, leave and are at fault, as gsbench devices and monitor show them.
#include "live_outlets.hpp"
#include "mqtt_outlet.hpp"
#include "parrot.hpp"
#include "spoilers.hpp"

#include <csignal>
#include <optional>
#include <utility>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

// The outlet logs in with a name of its own, on a broker that has only heard of it.
class OutletsThatCome : public testing::Test {
 protected:
  OutletsThatCome() {
    folder_.write("bench.password", broker_.bench().password + "\n");
    station_ = folder_.write(
        "station.toml", "title = \"Radio\"\nkind = \"physical\"\n[mqtt]\nurl = \"" + broker_.url() +
                            "\"\nca_file = \"" + broker_.ca_file() + "\"\nuser = \"" +
                            broker_.bench().user + "\"\npassword_file = \"bench.password\"\n");
  }

  const TemporaryFolder folder_;
  emulation::PrivateBroker broker_ =
      demand(emulation::PrivateBroker::start({folder_.file("broker"), {"early", "late"}}));
  std::string station_;
};

TEST_F(OutletsThatCome, OneThatJoinsLaterIsIdentifiedAndShown) {
  const MqttOutlet early(broker_, "early");
  const Started started = start_gsbench({"monitor", "--station", station_});
  EXPECT_TRUE(shows(started, "early "));
  {
    MqttOutlet late(broker_, "late");
    EXPECT_TRUE(shows(started, "late "));
    late.take_samples(1280);
    EXPECT_TRUE(until([&] {
      return text_of(started.out).find("measurement", text_of(started.out).find("late ")) !=
             std::string::npos;
    }));
  }
  EXPECT_TRUE(shows(started, "! left the broker"));
  EXPECT_EQ(stop(started, SIGINT).exit_code, 0);
}

TEST_F(OutletsThatCome, TheHelloIsShownWithItsSample) {
  MqttOutlet early(broker_, "early");
  early.take_samples(1280);
  const Started table = start_gsbench({"monitor", "--station", station_});
  EXPECT_TRUE(shows(table, " 1280 hello "));
  EXPECT_EQ(stop(table, SIGINT).exit_code, 0);
  const Started lines = start_gsbench({"monitor", "--station", station_, "--json"});
  EXPECT_TRUE(shows(lines, "joined"));
  const Outcome outcome = stop(lines, SIGINT);
  EXPECT_EQ(json::parse(lines_of(outcome.out).front())["sample"], 1280);
}

TEST_F(OutletsThatCome, ANamedOneIsWaitedFor) {
  const MqttOutlet early(broker_, "early");
  const Started started =
      start_gsbench({"monitor", "late", "--station", station_, "--wait", "600"});
  EXPECT_TRUE(says(started, "waiting for outlet late on the broker " + broker_.url()));
  const MqttOutlet late(broker_, "late");
  EXPECT_TRUE(shows(started, "board test"));
  const Outcome outcome = stop(started, SIGINT);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out.find("early"), std::string::npos);
}

TEST_F(OutletsThatCome, OfOthersThanTheNamedOneNothingIsShown) {
  const MqttOutlet late(broker_, "late");
  std::optional<MqttOutlet> early(std::in_place, broker_, "early", 1U);
  const Started named = start_gsbench({"monitor", "late", "--station", station_, "--json"});
  const Started table = start_gsbench({"monitor", "late", "--station", station_});
  const Started all = start_gsbench({"monitor", "--station", station_, "--json"});
  EXPECT_TRUE(shows(named, "\"late\""));
  EXPECT_TRUE(shows(table, "late"));
  EXPECT_TRUE(shows(all, "\"early\""));
  early.reset();
  EXPECT_TRUE(shows(all, R"("event":"left","id":"early","where":")" + broker_.url() + '"'));
  const MqttOutlet one(broker_, "early", 2);
  const MqttOutlet two(broker_, "early", 3);
  EXPECT_TRUE(shows(all, "has the same id"));
  EXPECT_EQ(stop(all, SIGINT).exit_code, 4);
  for (const Started& started : {named, table}) {
    const Outcome outcome = stop(started, SIGINT);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out.find("early"), std::string::npos) << outcome.out;
  }
}

TEST_F(OutletsThatCome, TwoWithTheSameIdAreReportedAlikeByBothCommands) {
  const MqttOutlet one(broker_, "early", 0x1111);
  const Started started = start_gsbench({"monitor", "--station", station_});
  EXPECT_TRUE(shows(started, "board test"));
  const MqttOutlet two(broker_, "early", 0x2222);
  const std::string fault =
      "has the same id as another outlet: instances 0x00001111 and 0x00002222";
  EXPECT_TRUE(shows(started, "early at " + broker_.url() + " ! " + fault));
  EXPECT_EQ(stop(started, SIGINT).exit_code, 4);
  const Outcome found = run_gsbench({"devices", "--station", station_});
  EXPECT_EQ(found.exit_code, 4);
  EXPECT_THAT(found.out, AllOf(HasSubstr("! early at "),
                               HasSubstr("has the same id as another outlet: instances 0x0000")));
}

TEST_F(OutletsThatCome, TwoThatEndEachOthersConnectionAreReportedAlikeByBothCommands) {
  const MqttOutlet one(broker_, "early");
  const Started started = start_gsbench({"monitor", "--station", station_, "--json"});
  EXPECT_TRUE(shows(started, "joined"));
  const MqttOutlet two(broker_, "early");
  EXPECT_TRUE(shows(started, R"({"event":"fault","id":"early","where":")" + broker_.url() +
                                 R"(","fault":"has the same id as another outlet: both have )"));
  EXPECT_EQ(stop(started, SIGINT).exit_code, 4);
  const Outcome found = run_gsbench({"devices", "--station", station_});
  EXPECT_EQ(found.exit_code, 4);
  EXPECT_THAT(found.out, HasSubstr("! early at " + broker_.url() +
                                   ": has the same id as another outlet: both have instance "));
}

TEST_F(OutletsThatCome, AnotherIdThanThatOfItsTopicIsAFaultOfTheTopic) {
  gs::wire::Uplink hello;
  gs::app::set_text(hello.hello.id, "late");
  hello.hello.sample_rate_hz = 8000;
  hello.hello.nominal_hz = 50;
  const Parrot early(broker_, "early", hello);
  const Outcome found = run_gsbench({"devices", "--station", station_, "--json"});
  EXPECT_EQ(found.exit_code, 4);
  const json listed = json::parse(found.out);
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(listed[0]["id"], "early");
  EXPECT_EQ(listed[0]["fault"], "reports another id there: \"late\"");
}

TEST_F(OutletsThatCome, AHelloThatCannotBeReadIsReportedAlikeByBothCommands) {
  gs::wire::Uplink hello;
  gs::app::set_text(hello.hello.id, "early");
  hello.hello.sample_rate_hz = 8000;
  hello.hello.nominal_hz = 55;
  const std::string fault = "its hello cannot be read: nominal_hz is 55, not 50 or 60";
  const Started started = start_gsbench({"monitor", "--station", station_, "--json"});
  EXPECT_TRUE(says(started, "waiting for"));
  const Parrot early(broker_, "early", hello);  // comes after the first look
  EXPECT_TRUE(shows(started, R"({"event":"fault","id":"early","where":")" + broker_.url() +
                                 R"(","fault":")" + fault + '"'));
  EXPECT_EQ(stop(started, SIGINT).exit_code, 4);
  const Outcome found = run_gsbench({"devices", "--station", station_});
  EXPECT_EQ(found.exit_code, 4);
  EXPECT_THAT(found.out, HasSubstr("! early at " + broker_.url() + ": " + fault));
}

TEST_F(OutletsThatCome, NoneOnABrokerIsNoFault) {
  const Outcome found = run_gsbench({"devices", "--station", station_});
  EXPECT_EQ(found.exit_code, 0);
  EXPECT_THAT(found.err, HasSubstr("no outlet answers"));
}

// The monitor ends before its first look for outlets that are missing.
TEST_F(OutletsThatCome, AHelloThatCannotBeReadIsReportedHoweverShortTheTime) {
  const MqttOutlet late(broker_, "late");
  gs::wire::Uplink hello;
  gs::app::set_text(hello.hello.id, "early");
  hello.hello.sample_rate_hz = 8000;
  hello.hello.nominal_hz = 55;
  const Parrot early(broker_, "early", hello);
  const Outcome shown = run_gsbench({"monitor", "--station", station_, "--seconds", "0.5"});
  EXPECT_EQ(shown.exit_code, 4);
  EXPECT_THAT(lines_of(shown.out).back(),
              HasSubstr("early at " + broker_.url() + " ! its hello cannot be read: nominal_hz"));
}

struct TwoWithTheSameId : LiveOutlets {
  TwoWithTheSameId() : LiveOutlets(Connection::kSerial, {"kitchen-1", "cellar"}) {}
};

TEST_F(TwoWithTheSameId, AreShownAgainOnceOneIsGone) {
  hardware_->cable(1).spoil(
      change_hello([](gs::wire::Hello& hello) { gs::app::set_text(hello.id, "kitchen-1"); }));
  const std::string other = hardware_->serial_ports()[1];
  const Started started = start_gsbench(to_it("monitor"));
  EXPECT_TRUE(shows(started, "the one on " + other));
  EXPECT_TRUE(shows(started, "the one on " + where_));
  hardware_->cable(1).unplug();
  EXPECT_TRUE(shows(started, " ! was unplugged from " + other));
  EXPECT_TRUE(until([&] {
    const std::string text = text_of(started.out);
    return text.find("measurement", text.find("was unplugged")) != std::string::npos;
  }));
  EXPECT_EQ(stop(started, SIGINT).exit_code, 0);
}

struct OneWithABadHello : LiveOutlets {
  OneWithABadHello() : LiveOutlets(Connection::kSerial) {}
};

TEST_F(OneWithABadHello, IsReportedWithTheReasonByBothCommands) {
  hardware_->cable(0).spoil(
      change_hello([](gs::wire::Hello& hello) { hello.tracker_delay_s = 2.0F; }));
  const std::string fault = "its hello cannot be read: tracker_delay_s is 2.000000, not 0 … 1";
  const Outcome found = run_gsbench(to_it("devices"));
  EXPECT_EQ(found.exit_code, 4);
  EXPECT_EQ(lines_of(found.out), Words{"! " + where_ + ": " + fault});
  const Outcome shown = run_gsbench(to_it("monitor", {"--wait", "4", "--json"}));
  EXPECT_EQ(shown.exit_code, 4);
  EXPECT_EQ(lines_of(shown.out), Words{R"({"event":"fault","where":")" + where_ + R"(","fault":")" +
                                       fault + R"(","format_version":1})"});
}

}  // namespace
}  // namespace gsbench::test

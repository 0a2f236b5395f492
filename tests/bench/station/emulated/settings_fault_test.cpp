// Settings that an outlet refuses, receives damaged or does not acknowledge. The bench checks the
// settings that it sends, so these tests change them between the bench and the outlet.
#include "station_of_four.hpp"

namespace gsbench::station::test {
namespace {

using gs::wire::Downlink;
using gs::wire::DownlinkKind;
using gs::wire::Uplink;
using gs::wire::UplinkKind;
using gsbench::test::Bytes;
using gsbench::test::each_message;

// Wraps the station's link and changes the settings sent to one outlet.
class ChangingLink final : public link::Link {
 public:
  ChangingLink(link::Link& real, std::string outlet, std::function<void(Downlink&)> change)
      : real_(real), outlet_(std::move(outlet)), change_(std::move(change)) {}
  drivers::Status open() override { return real_.open(); }
  drivers::Status send(const std::string& id, const Downlink& message) override {
    Downlink changed = message;
    if (id == outlet_ && message.kind == DownlinkKind::kSettings) {
      change_(changed);
    }
    return real_.send(id, changed);
  }
  drivers::Status poll(link::Happenings& happenings) override { return real_.poll(happenings); }
  void close() noexcept override { real_.close(); }

 private:
  link::Link& real_;
  std::string outlet_;  // its id
  std::function<void(Downlink&)> change_;
};

class ChangedStation final : public Station {
 public:
  ChangedStation(Station& real, std::size_t outlet, std::function<void(Downlink&)> change)
      : real_(real), link_(real.link(), real.slots()[outlet].serial_number, std::move(change)) {}
  std::string name() const override { return real_.name(); }
  source::Source& source() override { return real_.source(); }
  link::Link& link() override { return link_; }
  relay::RelaySense& relay_sense() override { return real_.relay_sense(); }
  std::vector<Slot> slots() const override { return real_.slots(); }
  std::chrono::milliseconds answers_within() const override { return real_.answers_within(); }
  bool outlets_count_ticks() const override { return real_.outlets_count_ticks(); }
  double block_s() const override { return real_.block_s(); }

 private:
  Station& real_;
  ChangingLink link_;
};

class SettingsFault : public FaultyStation {
 protected:
  void play_with(std::size_t outlet, std::function<void(Downlink&)> change) {
    ChangedStation changed(*station_, outlet, std::move(change));
    record_ = run(plan_, changed, {});
    expect_safe_state();
  }
};

// An emptied message is dropped.
emulation::Spoiler each_settings(const std::function<void(Bytes&)>& change) {
  return each_message([change](const Bytes& message) -> std::vector<Bytes> {
    Downlink downlink;
    std::uint32_t sequence = 0;
    Bytes changed = message;
    if (gs::wire::decode(message.data(), message.size(), downlink, sequence) ==
            gs::wire::Decoded::kOk &&
        downlink.kind == DownlinkKind::kSettings) {
      change(changed);
    }
    return changed.empty() ? std::vector<Bytes>{} : std::vector<Bytes>{changed};
  });
}

TEST_F(SettingsFault, OutOfRangeAreRefusedWithTheReason) {
  play_with(kM4, [](Downlink& message) { message.settings.lse_samples = 1; });
  expect_fault(kM4, "refused its settings: ");
}

TEST_F(SettingsFault, OutOfRangeAreRefusedBehindTheBrokerToo) {
  play_with(kRadioA, [](Downlink& message) { message.settings.switch_off_hz = -1.0F; });
  expect_fault(kRadioA, "refused its settings: ");
}

TEST_F(SettingsFault, OlderThanTheCurrentOnesAreRefused) {
  play();
  expect_all_complete();
  play_with(kHost, [](Downlink& message) { message.settings.version = 1; });
  expect_fault(kHost, "refused its settings: ");
  EXPECT_THAT(record_.outlets[kHost].fault, testing::HasSubstr("not newer"));
}

// Intact frames with half a message.
TEST_F(SettingsFault, ThatArriveTruncatedAreNotAcknowledged) {
  hardware().cable(kM4).spoil(
      each_settings([](Bytes& message) { message.resize(message.size() / 2); }),
      emulation::Way::kToOutlet);
  play();
  expect_fault(kM4, "did not acknowledge its settings");
}

TEST_F(SettingsFault, ThatNeverArriveAreNotAcknowledged) {
  hardware().cable(kHost).spoil(each_settings([](Bytes& message) { message.clear(); }),
                                emulation::Way::kToOutlet);
  play();
  expect_fault(kHost, "did not acknowledge its settings");
}

TEST_F(SettingsFault, WithALostAnswerAreReportedForThatOutletOnly) {
  hardware().cable(kM4).spoil(each_message([](const Bytes& message) -> std::vector<Bytes> {
    Uplink uplink;
    std::uint32_t sequence = 0;
    const auto decoded = gs::wire::decode(message.data(), message.size(), uplink, sequence);
    const bool answer =
        decoded == gs::wire::Decoded::kOk && uplink.kind == UplinkKind::kSettingsAnswer;
    return answer ? std::vector<Bytes>{} : std::vector<Bytes>{message};
  }));
  play();
  // The sequence numbers show the lost message before the answer is due.
  expect_fault(kM4, "of its messages were lost");
}

}  // namespace
}  // namespace gsbench::station::test

// The emulated DAC head for the conformance suite.
#include "instrument_rig.hpp"
#include <head_driver_test/running_head.hpp>
#include <test_support/demand.hpp>

namespace gsbench::test {
namespace {

// 0.15 s of samples, in the shortest messages, and a ping.
constexpr std::size_t kMostAhead = 1200 / 32 + 1;

class HeadInstrumentRig final : public InstrumentRig {
 public:
  Abilities abilities() const override {
    // Its firmware starts within a millisecond.
    return {"what answers is not a DAC head",
            "the head cannot be armed: it does not answer",
            1,
            kMostAhead,
            false,
            false,
            std::chrono::milliseconds(0)};
  }

  std::shared_ptr<source::Source> make_source() override {
    const std::shared_ptr<head::Head> driver = head::Head::create(options_for(*head_)).take();
    return {driver, &driver->source()};
  }
  bool output_is_on() override { return head_->observe().state == gs::head::State::kPlaying; }
  std::size_t commands() override { return head_->observe().frames; }

  void set_answers(Answers answers) override {
    const bool slow = answers == Answers::kSlow;
    head_->delay_to_bench(
        std::chrono::milliseconds(slow ? 30 : (answers == Answers::kTooSlow ? 700 : 0)));
    head_->spoil_to_bench([answers, halved = false](std::vector<std::uint8_t>& frame) mutable {
      if (answers == Answers::kNone) {
        frame.clear();
      } else if (answers == Answers::kHalf) {
        frame.resize(halved ? 0 : frame.size() / 2);
        halved = true;
      } else if (answers == Answers::kGarbage) {
        frame.assign({'?', '!', 0, '\n', 0xFF});
      }
    });
  }

  void lose_connection_at(int command) override { head_->drop_after(command); }
  void at_command(int command, std::function<void()> then) override {
    head_->after_frames(command, std::move(then));
  }
  void unplug() override { head_->unplug(); }
  void plug_in() override { demand(head_->plug_in()); }
  // The line stays connected.
  void reset(std::chrono::milliseconds) override { head_->restart(); }
  void become_another_model() override {
    head_->spoil_to_bench([](std::vector<std::uint8_t>& frame) {
      const std::string text = "-113,\"Undefined header\"\n";
      frame.assign(text.begin(), text.end());
    });
  }

 private:
  RunningHead head_;
};

}  // namespace

std::unique_ptr<InstrumentRig> dac_head() {
  return std::make_unique<HeadInstrumentRig>();
}

}  // namespace gsbench::test

// Runs on the emulated Cortex-M4F: gives the image's application one sample after another, and
// reads SysTick before and after each.
#include "counting.hpp"

#include <cmsdk.hpp>
#include <cortex_m4/core.hpp>

#include <new>

#include <app/endpoint.hpp>

namespace {

using gs::test::Counted;
using gs::test::CountingArguments;

constexpr std::uint32_t kCounterMask = 0xFFFFFFu;

template <class T>
T* at(std::uint32_t address) {
  return reinterpret_cast<T*>(address);
}

// Copies frames into memory, as a board copies them into the queue of its link.
class Outlet final : public gs::app::Carrier {
 public:
  Outlet(std::uint8_t* frames, std::uint32_t capacity) : frames_(frames), capacity_(capacity) {}

  bool send(const std::uint8_t* bytes, std::size_t count) override {
    if (count > capacity_ - length_) {
      return false;
    }
    for (std::size_t i = 0; i < count; ++i) {
      frames_[length_++] = bytes[i];
    }
    return true;
  }
  void start(const CountingArguments& arguments) {
    gs::app::Identity identity;
    gs::app::set_text(identity.id, "counted");
    app_.start(arguments.hardware, identity, nullptr, endpoint_, &arguments.settings);
  }
  void feed(const std::int16_t* sample) { app_.feed(sample, 1, endpoint_); }
  std::uint32_t frames_length() const { return length_; }

 private:
  std::uint8_t* frames_;
  std::uint32_t capacity_;
  std::uint32_t length_ = 0;
  gs::app::Application app_;
  gs::app::SerialEndpoint endpoint_{app_, *this};
};
static_assert(sizeof(Outlet) <= gs::test::kOutletBytes);

template <class Work>
std::uint32_t ticks_of(Work work) {
  const std::uint32_t before = gs::cortex_m4::systick->CVR;
  work();
  return (before - gs::cortex_m4::systick->CVR) & kCounterMask;  // it counts down
}

void loop(std::uint32_t rounds) {
  asm volatile(
      "1: subs %0, #1\n\t"
      "bne 1b"
      : "+r"(rounds)
      :
      : "cc", "memory");
}

}  // namespace

extern "C" void count_ticks(CountingArguments& arguments) {
  // Neither the firmware nor its watchdog may run meanwhile.
  asm volatile("cpsid i" ::: "memory");
  gs::mps2_an386::watchdog->CONTROL = 0;
  gs::cortex_m4::start_systick(kCounterMask + 1);

  auto* ticks = at<std::uint32_t>(arguments.ticks);
  const auto* samples = at<const std::int16_t>(arguments.samples);
  auto* outlet = at<Outlet>(arguments.outlet);
  switch (arguments.counted) {
    case Counted::kNothing:
      *ticks = ticks_of([] {});
      break;
    case Counted::kLoop:
      *ticks = ticks_of([&] { loop(arguments.rounds); });
      break;
    case Counted::kStart:
      outlet = new (outlet) Outlet(at<std::uint8_t>(arguments.frames), arguments.frames_capacity);
      outlet->start(arguments);
      break;
    case Counted::kFeed:
      for (std::uint32_t i = 0; i < arguments.count; ++i) {
        ticks[i] = ticks_of([&] { outlet->feed(samples + i); });
      }
      break;
  }
  if (arguments.counted == Counted::kStart || arguments.counted == Counted::kFeed) {
    arguments.frames_length = outlet->frames_length();
  }
}

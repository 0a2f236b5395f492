// An emulated DAC head: the firmware's code (firmware/head) in this process, behind a TCP port of
// 127.0.0.1 in place of the serial line. As on the board, the DAC gets its codes a millisecond
// ahead, 64 000 a second by the head's own clock, and holds each.
//
// Its time is that of the output: it goes on when render() is called, and stands still between two
// calls. Messages are served at once, by a thread of its own. A closed connection is like an
// unplugged line: the head does not notice it. One connection at a time; a new one replaces it.
#pragma once

#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <drivers/descriptor.hpp>
#include <drivers/result.hpp>
#include <emulation/listening.hpp>
#include <emulation/output.hpp>
#include <head/head.hpp>
#include <wire/frame.hpp>

namespace gsbench::emulation {

struct HeadEmulatorOptions {
  double clock_ppm = 0.0;       // positive: fast
  double full_scale_v = 1.444;  // largest deviation from mid-scale at the DAC's pin
  std::string board = "emulated";
  std::uint16_t flags = gs::head::kCrystalRuns;
};

class HeadEmulator final : public Output {
 public:
  static constexpr std::size_t kContacts = gs::head::kInputs;

  static drivers::Result<std::unique_ptr<HeadEmulator>> create(const HeadEmulatorOptions& options);
  ~HeadEmulator() override;
  HeadEmulator(const HeadEmulator&) = delete;
  HeadEmulator& operator=(const HeadEmulator&) = delete;

  // For transport::make_transport(): "tcp://127.0.0.1:40001".
  std::string port() const { return "tcp://127.0.0.1:" + std::to_string(port_.number()); }

  // V at the DAC's pin, relative to mid-scale. 0 after restart() until the firmware has started.
  void render(std::int64_t first_step, std::size_t count, float* volts) override;

  // The contact at input `channel` is closed or open from this step of true time on. In order of
  // time for each channel; the step may be up to 0.1 s before the steps rendered so far. All inputs
  // are open at first. May be called from any thread.
  void set_input(std::size_t channel, std::int64_t step, bool closed);

  // ---- Fault injection, from any thread.

  void unplug();
  // Unplugs when this many more frames have arrived.
  void unplug_after(int frames);
  // Closes the connection when this many more frames have arrived; it can be opened again.
  void drop_after(int frames);
  // Calls `then`, once, when this many more frames have arrived. From the emulator's thread; `then`
  // calls no function of this object.
  void after_frames(int frames, std::function<void()> then);
  // Frames reach the bench so much later.
  void delay_to_bench(std::chrono::milliseconds delay);
  [[nodiscard]] drivers::Status plug_in();
  // The firmware restarts: output off, session forgotten, a hello.
  void restart();
  // Silent: it neither reads nor sends; the output goes on.
  void be_silent(bool silent);
  // Called with the bytes of each read, to lose or damage some; may be empty. Called from the
  // emulator's thread.
  using Spoiler = std::function<void(std::vector<std::uint8_t>& bytes)>;
  void spoil_from_bench(Spoiler spoiler);
  // Called with the bytes of each frame.
  void spoil_to_bench(Spoiler spoiler);

  // ---- For tests.

  // Codes of the DAC, 64 000 a second of the head's own clock, from the first render() on.
  struct Observation {
    std::int64_t code = -1;          // at the output now
    std::int64_t stream_begin = -1;  // that of sample 0 of the newest stream
    std::int64_t last_driven = -1;   // the last one that was not mid-scale; -1: none yet
    std::int64_t last_frame = -1;    // at the output when the last complete frame arrived
    gs::head::State state = gs::head::State::kOff;
    std::size_t buffered = 0;  // samples of the stream
    std::size_t frames = 0;    // complete ones that have arrived
  };
  Observation observe() const;
  // Keeps all codes from now on; those before are recorded as mid-scale. Element n is code n.
  void record_codes();
  std::vector<std::uint16_t> recorded_codes() const;
  // The head's count of the capture timer at a step of true time.
  double count_at(std::int64_t step) const;

 private:
  using Lock = std::lock_guard<std::mutex>;
  struct InputEdge {
    std::int64_t step;
    std::size_t channel;
    bool closed;
  };
  static constexpr std::size_t kBlock = 64;  // codes of one interrupt of the DAC's DMA

  HeadEmulator(const HeadEmulatorOptions& options, LoopbackPort port, drivers::Descriptor wake);
  void start_firmware();
  void serve();
  void read_connection();
  void send_messages();
  void send_what_is_due();
  void pass_edges();
  double code_at(std::int64_t step) const;
  std::uint16_t code(std::int64_t number);
  int output(std::int64_t number);  // the code now at the output
  void ring() const;

  const HeadEmulatorOptions options_;
  mutable std::mutex mutex_;  // guards all below, except the thread
  LoopbackPort port_;
  drivers::Descriptor connection_;
  drivers::Descriptor wake_;
  std::optional<gs::head::Head> head_;
  gs::wire::FrameReader reader_;
  std::array<std::uint16_t, 2 * kBlock> codes_{};  // the block at the output and the next one
  std::int64_t blocks_ = 0;                        // made so far
  std::int64_t end_step_ = 0;                      // rendered up to here
  std::deque<InputEdge> edges_;
  std::array<bool, gs::head::kInputs> closed_{};
  Observation observation_;
  bool recording_ = false;
  std::vector<std::uint16_t> recorded_;
  Spoiler from_bench_;
  Spoiler to_bench_;
  struct Delayed {
    std::chrono::steady_clock::time_point due;
    std::vector<std::uint8_t> frame;
  };
  std::chrono::milliseconds delay_{0};
  std::deque<Delayed> delayed_;
  int frames_until_unplugged_ = 0;  // 0: not
  int frames_until_then_ = 0;       // 0: never
  std::function<void()> then_;
  bool refuses_afterwards_ = true;
  bool silent_ = false;
  bool ending_ = false;
  bool unplugging_ = false;
  std::condition_variable unplugged_;
  std::thread thread_;
};

}  // namespace gsbench::emulation

// A bench that streams to a head with the real driver until it is killed (killed_bench_test.cpp):
// it energises, holds for 0.3 s, and plays a minute of mains voltage. argv: the port.
#include <head_driver/head.hpp>
#include <test_support/mains.hpp>

#include <chrono>
#include <cstdio>
#include <exception>
#include <thread>

int main(int, char** argv) {
  try {
    gsbench::head::HeadOptions options;
    options.port = argv[1];
    const auto head = gsbench::head::Head::create(options).take();
    gsbench::source::Source& source = head->source();
    const gsbench::test::Mains mains;
    gsbench::test::demand(source.prepare(mains));
    gsbench::test::demand(source.energise());
    for (int i = 0; i < 15; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      gsbench::test::demand(source.hold());
    }
    gsbench::test::demand(source.start());
    for (std::int64_t tick = 0; tick < mains.total_ticks();) {
      const auto played = source.advance(std::min(tick + 80, mains.total_ticks()));
      gsbench::test::demand(played);
      tick = played.value();
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

#include <thread>

#include <source/interrupt.hpp>

namespace gsbench::source {

drivers::Status Interrupt::wait_until(Clock::time_point time) {
  while (!is_set()) {
    if (Clock::now() >= time) {
      return drivers::Done{};
    }
    std::this_thread::sleep_until(part_of(time));
  }
  return error();
}

}  // namespace gsbench::source

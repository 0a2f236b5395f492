#include <shared_memory_io/shared_port.hpp>

namespace gs::shared_memory_io {
namespace {

// Acquire and release: data is visible before the counter that counts it.
std::uint32_t read_counter(const volatile std::uint32_t& counter) {
  return __atomic_load_n(&counter, __ATOMIC_ACQUIRE);
}
void write_counter(volatile std::uint32_t& counter, std::uint32_t value) {
  __atomic_store_n(&counter, value, __ATOMIC_RELEASE);
}

}  // namespace

void SharedPort::start() {
  terminals_.starts = terminals_.starts + 1;
  terminals_.taken = terminals_.written;
}

std::size_t SharedPort::take_samples(std::int16_t* out, std::size_t most, std::uint32_t& lost) {
  const std::uint32_t taken = terminals_.taken;
  const std::uint32_t waiting = read_counter(terminals_.written) - taken;
  std::size_t count = waiting < most ? waiting : most;
  const volatile std::int16_t* const ring = terminals_.ring;
  for (std::size_t i = 0; i < count; ++i) {
    out[i] = ring[(taken + i) % kRingSamples];
  }
  // Read after the copy (volatile keeps the order): samples overwritten during the copy are lost,
  // too.
  const std::uint32_t ahead = terminals_.written - taken;
  lost = 0;
  if (ahead > kRingSamples) {
    // Continues half a ring behind the newest sample, which the bench does not overwrite soon.
    lost = ahead - kRingSamples / 2;
    count = 0;
  }
  write_counter(terminals_.taken, taken + lost + static_cast<std::uint32_t>(count));
  return count;
}

bool SharedPort::relay_closed() const {
  const std::uint32_t edges = terminals_.edges;
  return edges == 0 || terminals_.edge[(edges - 1) % kPinEdges].closed != 0;
}

void SharedPort::drive_relay(bool closed) {
  if (closed == relay_closed()) {
    return;
  }
  const std::uint32_t edges = terminals_.edges;
  terminals_.edge[edges % kPinEdges] = {terminals_.taken, closed ? 1u : 0u};
  write_counter(terminals_.edges, edges + 1);
}

}  // namespace gs::shared_memory_io

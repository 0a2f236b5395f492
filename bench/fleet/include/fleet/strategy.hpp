// Ways to control the load of a fleet after a loss, which a closed loop compares.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <profile/plan.hpp>

namespace gsbench::fleet {

enum class Strategy : std::uint8_t {
  kNone,
  kPaper,    // outlets that decide as the paper's: setting method = 0
  kGsbench,  // outlets that decide by the grid's state: method = 1
  kCentral,  // a controller that knows the lost power, after its delay; eq. (15)
  kUfls,     // under-frequency load shedding by relays
  // These know the state of the grid at once, a loss 0.3, 0.5, 0.75 or 0.96 s after it happens,
  // and a return of power at once. Every 16 ms they shed by fleet/clairvoyant.hpp.
  kClairvoyant300ms,
  kClairvoyant500ms,
  kClairvoyant750ms,
  kClairvoyant960ms,
};

const char* to_string(Strategy strategy);  // "none", "clairvoyant-0.3"
const std::vector<Strategy>& all_strategies();
bool has_outlets(Strategy strategy);
std::optional<double> knows_loss_after_s(Strategy strategy);  // T of a clairvoyant

// The lost power of a recorded frequency is not known.
bool plays_recorded_frequency(const profile::Plan& plan);

// False for central control and the clairvoyants if the lost power is not known.
bool is_possible(const profile::Plan& plan, Strategy strategy);

}  // namespace gsbench::fleet

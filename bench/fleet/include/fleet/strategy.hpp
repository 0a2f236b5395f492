// Controls of a fleet's load that a closed loop compares.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <profile/plan.hpp>

namespace gsbench::fleet {

enum class Strategy : std::uint8_t {
  kNone,
  kPaper,    // outlets that decide by the paper's rules: setting method = 0
  kGsbench,  // outlets that decide by the grid's state: setting method = 1
  kCentral,  // a controller that knows the lost power after its delay, and sheds by eq. (29)
  kUfls,     // under-frequency load shedding by relays
  // Reference controls that shed by fleet/clairvoyant.hpp every 16 ms. They know a loss 0.3, 0.5,
  // 0.75 or 0.96 s after it happens.
  kClairvoyant300ms,
  kClairvoyant500ms,
  kClairvoyant750ms,
  kClairvoyant960ms,
};

const char* to_string(Strategy strategy);  // such as "none" or "clairvoyant-0.3"
const std::vector<Strategy>& all_strategies();
bool has_outlets(Strategy strategy);
// The delay T of a clairvoyant; nothing for other strategies.
std::optional<double> knows_loss_after_s(Strategy strategy);

// Whether the profile plays a changing frequency, by points or a recording. The lost power is then
// not known.
bool plays_recorded_frequency(const profile::Plan& plan);

// False for central control and clairvoyants if the profile plays a recorded frequency.
bool is_possible(const profile::Plan& plan, Strategy strategy);

}  // namespace gsbench::fleet

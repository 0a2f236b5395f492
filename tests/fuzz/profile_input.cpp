#include "profile_input.hpp"

#include <cmath>
#include <exception>
#include <regex>
#include <set>

namespace gsbench::fuzz {
namespace {

std::string wrong_with_plan(const profile::Plan& plan) {
  if (plan.duration_ticks() <= 0) {
    return "the duration is not positive";
  }
  if (plan.expectations.empty()) {
    return "no limits";
  }
  if (plan.outlets.empty()) {
    return "no outlets";
  }
  std::set<std::string> ids;
  for (const profile::Outlet& outlet : plan.outlets) {
    ids.insert(outlet.id);
  }
  if (ids.size() != plan.outlets.size()) {
    return "two outlets with the same id";
  }
  for (const profile::SettingsUpdate& update : plan.settings) {
    for (const auto& [id, settings] : update.outlets) {
      if (ids.count(id) == 0) {
        return "settings for an unknown outlet";
      }
    }
  }
  for (const profile::Command& command : plan.commands) {
    for (const std::string& id : command.outlets) {
      if (ids.count(id) == 0) {
        return "a command to an unknown outlet";
      }
    }
  }
  const waveform::Synthesizer synthesizer = plan.synthesizer();
  for (const std::int64_t tick : {std::int64_t{0}, plan.duration_ticks() - 1}) {
    const double t_s =
        static_cast<double>(tick) / static_cast<double>(synthesizer.sample_rate_hz());
    float sample = 0.0F;
    synthesizer.render(tick, 1, &sample);
    if (!std::isfinite(sample)) {
      return "a sample that is not finite";
    }
    if (!std::isfinite(synthesizer.reference().frequency_hz(t_s))) {
      return "a frequency that is not finite";
    }
  }
  return "";
}

}  // namespace

profile::Plan parse_as_gsbench(const std::string& text) {
  return profile::parse_profile(text, "fuzz.toml");
}

std::string wrong_with(const std::string& text, const ParseProfile& parse) {
  // Messages may quote the text, including line breaks.
  static const std::regex kPlaced(R"(^[^\n:]+:[1-9][0-9]*:[1-9][0-9]*: [^])");
  try {
    return wrong_with_plan(parse(text));
  } catch (const profile::ConfigurationError& error) {
    const std::string message = error.what();
    const bool placed = std::regex_search(
        message.begin(),
        message.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(message.size(), 1000)),
        kPlaced);
    return placed ? "" : "refused without line and column: " + message;
  } catch (const std::exception& error) {
    return std::string("exception of another type: ") + error.what();
  }
}

}  // namespace gsbench::fuzz

#include "generator_scpi_dialect.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gsbench::emulation {

std::string short_form(std::string_view name) {
  const auto end = std::find_if(name.begin(), name.end(), [](char c) { return c >= 'a'; });
  return {name.begin(), end};
}

std::size_t ScpiDialect::text_size(std::string_view message) const {
  for (std::size_t i = 0; i + 1 < message.size(); ++i) {
    if (message[i] == '#' && message[i + 1] >= '1' && message[i + 1] <= '9') {
      return i;
    }
  }
  return trimmed(message).size();
}

GeneratorReply ScpiDialect::execute(std::string_view message) {
  GeneratorReply reply;
  bool answers = false;
  for (const ScpiUnit& unit : units_of(message)) {
    const std::size_t before = reply.bytes.size();
    if (execute(unit, reply)) {
      if (answers) {
        reply.bytes.insert(before, ";");
      }
      answers = true;
    }
  }
  if (answers) {
    reply.bytes += '\n';
  }
  return reply;
}

bool ScpiDialect::execute(const ScpiUnit& unit, GeneratorReply& reply) {
  const auto answer = [&](const std::string& text) {
    reply.bytes += text;
    reply.not_before = std::max(reply.not_before, ready_for_query());
    return true;
  };
  if (unit.header == "*IDN" && unit.query) {
    const std::string& other = state_.faults().identity;
    return answer(other.empty() ? state_.facts().identity : other);
  }
  if (unit.header == "*OPC" || unit.header == "*WAI") {
    if (unit.query || unit.header == "*WAI") {
      reply.not_before = std::max(reply.not_before, complete());
    }
    return unit.query && answer("1");
  }
  if (unit.query && (unit.header == "*ESR" || unit.header == "*STB" || unit.header == "*TST")) {
    return answer("+0");
  }
  if (unit.query && matches(unit.header, "SYSTem:ERRor[:NEXT]")) {
    return answer(errors_.next());
  }
  if (!unit.query && unit.header == "*CLS") {
    errors_.clear();
    return false;
  }
  if (!unit.query && unit.header == "*RST") {
    state_.reset();
    reset();
    return false;
  }
  if (!unit.query && unit.header == "*TRG") {
    trigger();
    return false;
  }
  for (const Row& row : rows_) {
    if ((unit.query ? static_cast<bool>(row.query) : static_cast<bool>(row.set)) &&
        matches(unit.header, row.pattern)) {
      if (unit.query) {
        return answer(row.query(unit.argument));
      }
      row.set(unit.argument);
      return false;
    }
  }
  error(-113, "Undefined header");
  return false;
}

void ScpiDialect::number(std::string_view argument, double low, double high,
                         const std::function<void(double)>& take) {
  if (is_form_of(argument, "MINimum")) {
    take(low);
    return;
  }
  if (is_form_of(argument, "MAXimum")) {
    take(high);
    return;
  }
  const auto value = number_of(argument);
  if (!value) {
    error(argument.empty() ? -109 : -104,
          argument.empty() ? "Missing parameter" : "Data type error");
    return;
  }
  // The rounding of decimal numbers is not out of range.
  const double lowest = low - 1e-9 * std::abs(low);
  const double highest = high + 1e-9 * std::abs(high);
  if (!(*value >= lowest && *value <= highest)) {
    if (const auto taken = out_of_range(*value < low ? low : high); taken) {
      take(*taken);
    }
    return;
  }
  take(*value < low ? low : std::min(*value, high));
}

void ScpiDialect::flag(std::string_view argument, const std::function<void(bool)>& take) {
  if (const auto value = switch_of(argument); value) {
    take(*value);
  } else {
    error(-104, "Data type error");
  }
}

std::string_view ScpiDialect::one_of(std::string_view argument,
                                     std::initializer_list<std::string_view> names) {
  const auto* const found = std::find_if(names.begin(), names.end(), [&](std::string_view name) {
    return is_form_of(argument, name);
  });
  if (found == names.end()) {
    error(-224, "Illegal parameter value");
    return "";
  }
  return *found;
}

void ScpiDialect::add_number(std::string_view pattern, double GeneratorSettings::*setting,
                             Range range) {
  add(
      pattern,
      [this, setting, range = std::move(range)](std::string_view argument) {
        const auto [low, high] = range();
        number(argument, low, high, [&](double value) {
          change([&](GeneratorSettings& next) { next.*setting = value; });
        });
      },
      [this, setting](std::string_view) { return written(state_.settings().*setting); });
}

void ScpiDialect::add_flag(std::string_view pattern, bool GeneratorSettings::*setting) {
  add(
      pattern,
      [this, setting](std::string_view argument) {
        flag(argument,
             [&](bool on) { change([&](GeneratorSettings& next) { next.*setting = on; }); });
      },
      [this, setting](std::string_view) { return written(state_.settings().*setting); });
}

void ScpiDialect::add_load(std::string_view pattern) {
  add(
      pattern,
      [this](std::string_view argument) {
        if (is_form_of(argument, "INFinity")) {
          state_.set_load(std::numeric_limits<double>::infinity());
          return;
        }
        number(argument, 1, 10e3, [this](double load_ohm) { state_.set_load(load_ohm); });
      },
      [this](std::string_view) { return written(state_.settings().load_ohm); });
}

void ScpiDialect::add_polarity(std::string_view normal, std::string_view inverted) {
  add(
      "OUTPut:POLarity",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"NORMal", "INVerted"});
        if (!name.empty()) {
          change([&](GeneratorSettings& next) { next.inverted = name == "INVerted"; });
        }
      },
      [this, normal, inverted](std::string_view) {
        return std::string(state_.settings().inverted ? inverted : normal);
      });
}

ScpiDialect::Range ScpiDialect::frequencies() const {
  return
      [this] { return std::pair(1e-6, state_.highest_frequency_hz(state_.settings().function)); };
}

ScpiDialect::Range ScpiDialect::offsets() const {
  return [this] {
    const double room =
        std::max(0.0, state_.highest_peak_v() - state_.settings().amplitude_vpp / 2);
    return std::pair(-room, room);
  };
}

void ScpiDialect::change(const std::function<void(GeneratorSettings&)>& edit) {
  GeneratorSettings next = state_.settings();
  edit(next);
  state_.set(next);
}

}  // namespace gsbench::emulation

#include "generator_scpi_dialect.hpp"

#include <algorithm>
#include <cmath>

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
  const double slack = 1e-9 * std::max(std::abs(low), std::abs(high));
  if (*value < low - slack || *value > high + slack) {
    if (const auto taken = out_of_range(*value < low ? low : high); taken) {
      take(*taken);
    }
    return;
  }
  take(*value);
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

void ScpiDialect::change(const std::function<void(GeneratorSettings&)>& edit) {
  GeneratorSettings next = state_.settings();
  edit(next);
  state_.set(next);
}

}  // namespace gsbench::emulation

// The settings, how they are asked back, and the error queue.
#include "session.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Done;
using drivers::Result;
using drivers::Status;

namespace {

// The deepest error queue of the instruments here has 20 entries.
constexpr int kMostErrors = 100;

}  // namespace

Status Session::set(When when) {
  std::vector<const Setting*> sent;
  for (const Setting& setting : instrument_.settings) {
    if (setting.when != when) {
      continue;
    }
    for (const std::string& command : setting.commands) {
      if (Status done = connection_.send(text(command)); !done.ok()) {
        return done;
      }
    }
    sent.push_back(&setting);
  }
  Status same = ask_back(sent);
  return same.ok() ? expect_no_error("the settings") : same;
}

Status Session::compare(const Setting& setting, const std::string& answer) const {
  const Result<std::string> found = value_in(answer, setting.asked.field);
  if (!found.ok()) {
    return setting.may_be_missing
               ? Status(Done{})
               : error(fmt::format("{}: the answer {}", setting.name, found.error()));
  }
  const std::string expected = text(setting.expected);
  bool same = false;
  if (setting.compare == Compare::kText) {
    same = is_one_of(found.value(), expected);
  } else {
    const Result<double> number = number_in(found.value(), setting.unit);
    const Result<double> wanted = number_in(expected, "");
    if (!number.ok() || !wanted.ok()) {
      return error(
          fmt::format("{}: {}", setting.name, number.ok() ? wanted.error() : number.error()));
    }
    const double tolerance =
        std::max(setting.tolerance, 1e-6 * setting.tolerance_ppm * std::fabs(wanted.value()));
    same = std::fabs(number.value() - wanted.value()) <= tolerance;
  }
  if (same) {
    return Done{};
  }
  return error(
      fmt::format("{} is {}, but {} was set", setting.name, printable(found.value()), expected));
}

// Settings with the same query share one answer.
Status Session::ask_back(const std::vector<const Setting*>& settings) {
  std::map<std::string, std::string> answers;
  for (const Setting* const setting : settings) {
    const std::string query = text(setting->asked.query);
    if (answers.count(query) == 0) {
      Result<std::string> answer = connection_.ask(query);
      if (!answer.ok()) {
        return error(fmt::format("{}: {}", setting->name, answer.error()));
      }
      answers[query] = answer.take();
    }
    if (Status same = compare(*setting, answers[query]); !same.ok()) {
      return same;
    }
  }
  return Done{};
}

Status Session::all_at(bool playing) {
  std::vector<const Setting*> asked;
  for (const Setting& setting : instrument_.settings) {
    if (!playing || setting.watched) {
      asked.push_back(&setting);
    }
  }
  return ask_back(asked);
}

// Errors that were there before are not ours.
Status Session::forget_errors() {
  if (instrument_.dialect.next_error.empty()) {
    return Done{};
  }
  for (int i = 0; i < kMostErrors; ++i) {
    const Result<std::string> next = connection_.ask(text(instrument_.dialect.next_error));
    if (!next.ok()) {
      return error(fmt::format("error queue: {}", next.error()));
    }
    const Result<std::string> number = value_in(next.value(), "1");
    const Result<double> code = number_in(number.ok() ? number.value() : next.value(), "");
    if (!code.ok()) {
      return error(fmt::format("error queue: {}", code.error()));
    }
    if (code.value() == 0.0) {
      return Done{};
    }
  }
  return error(fmt::format("the error queue is not empty after {} entries", kMostErrors));
}

Status Session::expect_no_error(const std::string& after) {
  if (instrument_.dialect.next_error.empty()) {
    return Done{};
  }
  const Result<std::string> next = connection_.ask(text(instrument_.dialect.next_error));
  if (!next.ok()) {
    return error(fmt::format("error queue: {}", next.error()));
  }
  const Result<std::string> number = value_in(next.value(), "1");
  const Result<double> code = number_in(number.ok() ? number.value() : next.value(), "");
  if (code.ok() && code.value() == 0.0) {
    return Done{};
  }
  return error(fmt::format("reports an error after {}: {}", after, printable(next.value())));
}

}  // namespace gsbench::scpi

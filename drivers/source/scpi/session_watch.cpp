// What is asked while the waveform plays.
#include "session.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Done;
using drivers::Result;
using drivers::Status;

// The output and settings with the same query share one answer.
std::vector<std::string> Session::watched_queries() const {
  std::vector<std::string> queries = {text(instrument_.dialect.output.query)};
  for (const Setting& setting : instrument_.settings) {
    const std::string query = text(setting.asked.query);
    if (setting.watched && std::count(queries.begin(), queries.end(), query) == 0) {
      queries.push_back(query);
    }
  }
  return queries;
}

Status Session::ask_next() {
  return reconnecting([&] { return connection_.begin_query(questions_[next_question_]); });
}

Status Session::watch() {
  if (!is_asking()) {
    return ask_next();
  }
  const Result<std::optional<std::string>> answer = connection_.poll_answer();
  if (!answer.ok()) {
    if (connection_.is_open() || interrupt_.is_set() || lost_) {
      return error(answer.error());
    }
    lost_ = true;
    return ask_next();
  }
  if (!answer.value()) {
    return Done{};
  }
  lost_ = false;
  const std::string& query = questions_[next_question_];
  next_question_ = (next_question_ + 1) % questions_.size();
  return check_watched(query, *answer.value());
}

Status Session::check_watched(const std::string& query, const std::string& answer) {
  if (query == text(instrument_.dialect.output.query)) {
    if (Status on = compare_output(true, answer); !on.ok()) {
      return on;
    }
  }
  for (const Setting& setting : instrument_.settings) {
    if (setting.watched && text(setting.asked.query) == query) {
      if (Status same = compare(setting, answer); !same.ok()) {
        return same;
      }
    }
  }
  return Done{};
}

}  // namespace gsbench::scpi

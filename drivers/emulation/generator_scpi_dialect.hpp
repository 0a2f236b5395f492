// What the dialects of Rigol and Keysight share: SCPI messages, an error queue, common commands.
#pragma once

#include "generator_dialect.hpp"
#include "generator_scpi.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace gsbench::emulation {

class ScpiDialect : public GeneratorDialect {
 public:
  ScpiDialect(GeneratorState& state, ScpiErrors errors)
      : state_(state), errors_(std::move(errors)) {}

  std::size_t message_size(std::string_view bytes) override { return framing_.message_size(bytes); }
  bool in_block() const override { return framing_.in_block(); }
  void give_up_block() override {
    framing_.forget();
    error(-161, "Invalid block data");
  }
  void connect() override { framing_.forget(); }
  void fill_errors() override { errors_.fill(); }
  void lose_power() override { errors_.clear(); }
  std::size_t text_size(std::string_view message) const override;
  GeneratorReply execute(std::string_view message) override;

 protected:
  using Set = std::function<void(std::string_view)>;
  using Query = std::function<std::string(std::string_view)>;
  struct Row {
    std::string_view pattern;  // as matches() reads it
    Set set;                   // empty: query only
    Query query;               // empty: command only
  };

  // Rows are tried in this order.
  void add(std::string_view pattern, Set set, Query query) {
    rows_.push_back({pattern, std::move(set), std::move(query)});
  }
  void error(int number, std::string_view text) { errors_.add(number, text); }

  // Calls `take` with the number; an error if the argument is none or below `low`, above `high`.
  // MIN and MAX are the limits.
  void number(std::string_view argument, double low, double high,
              const std::function<void(double)>& take);
  void flag(std::string_view argument, const std::function<void(bool)>& take);
  // The name of `names` of which the argument is a form; empty and an error if of none.
  std::string_view one_of(std::string_view argument, std::initializer_list<std::string_view> names);
  // Rows of settings. `range` is asked when a number is set.
  using Range = std::function<std::pair<double, double>()>;
  void add_number(std::string_view pattern, double GeneratorSettings::*setting, Range range);
  void add_number(std::string_view pattern, double GeneratorSettings::*setting, double low,
                  double high) {
    add_number(pattern, setting, [low, high] { return std::pair(low, high); });
  }
  void add_flag(std::string_view pattern, bool GeneratorSettings::*setting);
  void add_load(std::string_view pattern);
  void add_polarity(std::string_view normal, std::string_view inverted);  // as they are answered
  // The lowest and highest of a setting, with the others as they are.
  Range frequencies() const;
  Range offsets() const;

  // A copy of the settings is changed and set.
  void change(const std::function<void(GeneratorSettings&)>& edit);

  virtual std::string written(double value) const = 0;
  virtual std::string written(bool on) const = 0;
  // What a maker does with a number out of range: refuse it (none) or take the limit.
  virtual std::optional<double> out_of_range(double limit) = 0;
  // Step from which on queries, *OPC? and *WAI are answered.
  virtual std::int64_t ready_for_query() const { return std::numeric_limits<std::int64_t>::min(); }
  virtual std::int64_t complete() const = 0;
  virtual void trigger() = 0;  // *TRG
  virtual void reset() = 0;    // *RST, after the settings

  GeneratorState& state_;

 private:
  // Executes a unit; returns whether it has an answer.
  bool execute(const ScpiUnit& unit, GeneratorReply& reply);

  ScpiErrors errors_;
  ScpiFraming framing_;
  std::vector<Row> rows_;
};

// The short form of a name, as instruments answer it: "SIN" of "SINusoid".
std::string short_form(std::string_view name);

}  // namespace gsbench::emulation

// What is done with one waveform generator, step by step. Every step asks back what it set.
#pragma once

#include "connection.hpp"
#include "text.hpp"
#include <source_scpi/instrument.hpp>
#include <source_scpi/planner.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <source/source.hpp>

namespace gsbench::scpi {

struct Triggered {
  transport::Clock::time_point sent;
  double late_s = 0.0;  // the instrument may have been later than usual by so much
};

class Session {
 public:
  // `instrument` and `interrupt` must outlive the session. All functions return an error if
  // interrupted.
  Session(const Instrument& instrument, const std::string& port, int baud, int channel,
          source::Interrupt& interrupt);

  // Connects if needed, switches the output off, sets everything and loads the waveform.
  drivers::Status load(const Plan& plan, const source::Progress& progress);
  // Asks for all settings. Reconnects once if the connection is lost.
  drivers::Status check_settings();
  // The same, for the settings that can be asked while playing, and for the output, which must be
  // on.
  drivers::Status check_playing();
  // The same, but one question at a time, and without waiting for answers: a call sends the next
  // question, or looks whether the last one has been answered. An error if the answer is wrong or
  // late. Reconnects once if the connection is lost, which blocks for the time of two answers.
  drivers::Status watch();
  // The last question of watch() is not yet answered.
  bool is_asking() const { return connection_.has_query(); }
  // Number of different questions of watch(). Valid from load() on.
  std::size_t questions() const { return questions_.size(); }
  drivers::Status switch_on();
  drivers::Result<Triggered> trigger();
  // Switches the output off and asks. Tries for `longest_s`, reconnecting. An error: the state of
  // the output is unknown, or it is still on.
  drivers::Status make_safe(double longest_s);

 private:
  drivers::Status connect();
  drivers::Status reconnecting(const std::function<drivers::Status()>& step);
  drivers::Status load_once(const Plan& plan, const source::Progress& progress);
  drivers::Status reset();
  drivers::Status clear_memory();
  drivers::Status upload(const Plan& plan, const source::Progress& progress);
  drivers::Status upload_packets(const Plan& plan, const source::Progress& progress);
  drivers::Status output_still_off();
  drivers::Status verify(const Plan& plan);
  drivers::Status set(When when);
  drivers::Status compare(const Setting& setting, const std::string& answer) const;
  drivers::Status ask_back(const std::vector<const Setting*>& settings);
  drivers::Status all_at(bool playing);
  std::vector<std::string> watched_queries() const;
  drivers::Status ask_next();
  drivers::Status check_watched(const std::string& query, const std::string& answer);
  drivers::Status switch_output(bool on);
  drivers::Status compare_output(bool on, const std::string& answer) const;
  drivers::Status expect_output(bool on);
  drivers::Status forget_errors();
  drivers::Status expect_no_error(const std::string& after);
  std::string text(const std::string& form) const { return filled(form, values_); }
  drivers::Error error(const std::string& what) const;

  const Instrument& instrument_;
  std::string port_;
  source::Interrupt& interrupt_;
  Connection connection_;
  Values values_;
  std::vector<std::string> questions_;  // of watch()
  std::size_t next_question_ = 0;
  bool lost_ = false;  // the connection, since the last answer to watch()
};

}  // namespace gsbench::scpi

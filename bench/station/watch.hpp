// Watches the outlets during a run. An outlet that reports an error, leaves, stops reporting,
// restarts or does not acknowledge its settings gets that fault in its record.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <capture/capture.hpp>
#include <link/link.hpp>
#include <record/run_record.hpp>

namespace gsbench::station {

class Watch {
 public:
  // Watches the outlets that were sent settings.
  Watch(std::vector<record::OutletRecord>& outlets, std::int64_t sample_rate_hz);

  bool is_watched(const std::string& id) const { return sessions_.count(id) > 0; }
  // Processes everything received up to the source's tick `now`. Removes the messages of outlets
  // that are not watched and all messages after a restart of an outlet, whose sample count starts
  // at 0 again.
  void process(link::Happenings& happenings, std::int64_t now);
  void check_answers(const capture::Capture& capture);
  // Settings were sent again to an outlet `at_s` after the start of the run. It must have answered
  // by the source's tick `due`.
  void expect_answer(const std::string& id, double at_s, std::int64_t due);
  // Checks the answers that are due by the source's tick `now`.
  void check_later_answers(const capture::Capture& capture, std::int64_t now);
  void check_silence(const capture::Capture& capture, std::int64_t now);

 private:
  struct LaterAnswer {
    double at_s;
    std::int64_t due;
  };

  void process(const link::Change& change);

  // The time from one start-up of an outlet to the next.
  struct Session {
    record::OutletRecord* outlet;
    std::optional<std::uint32_t> start_number = {};  // of the first message
    std::int64_t last_message_tick = 0;              // of the source
    bool ended = false;
    std::vector<LaterAnswer> later_answers = {};  // in the order of sending
    std::size_t later_answers_checked = 0;
  };

  std::map<std::string, Session> sessions_;
  std::int64_t longest_silence_ticks_;
};

}  // namespace gsbench::station

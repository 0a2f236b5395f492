// Watches over what the outlets of a run say while it is played: who reports an error, leaves,
// falls silent, restarts, or does not answer to its settings has that fault in its record.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <capture/capture.hpp>
#include <link/link.hpp>
#include <record/run_record.hpp>

namespace gsbench::station {

class Watch {
 public:
  // Over those that were sent settings.
  Watch(std::vector<record::OutletRecord>& outlets, std::int64_t sample_rate_hz);

  bool is_watched(const std::string& id) const { return lives_.count(id) > 0; }
  // Heard by the source's tick `now`. Takes out of the messages those of outlets that are not
  // watched, and what an outlet said after it restarted: it counts anew, and nothing aligns that
  // count.
  void hear(link::Happenings& happenings, std::int64_t now);
  void check_answers(const capture::Capture& capture);
  void check_silence(const capture::Capture& capture, std::int64_t now);

 private:
  // An outlet's count of its samples, from its start-up on.
  struct Life {
    record::OutletRecord* outlet;
    std::uint64_t newest_sample = 0;
    std::int64_t heard_tick = 0;  // of the source
    bool over = false;
  };

  std::map<std::string, Life> lives_;
  std::int64_t longest_silence_ticks_;
};

}  // namespace gsbench::station

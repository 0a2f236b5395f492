// Watches over what the outlets of a run say while it is played: who reports an error, falls
// silent, restarts, or does not answer to its settings has that fault in its record.
#pragma once

#include <cstdint>
#include <vector>

#include <capture/capture.hpp>
#include <link/link.hpp>
#include <record/run_record.hpp>

namespace gsbench::station {

class Watch {
 public:
  Watch(std::vector<record::OutletRecord>& outlets, std::int64_t sample_rate_hz)
      : outlets_(outlets), lives_(outlets.size()), sample_rate_hz_(sample_rate_hz) {}

  // Heard by the source's tick `now`. What an outlet said after it restarted is taken out of the
  // messages: it counts anew, and nothing aligns that count.
  void hear(std::vector<link::Received>& messages, std::int64_t now);
  void note_faults(const std::vector<link::Fault>& faults);
  void check_answers(const capture::Capture& capture);
  void check_silence(const capture::Capture& capture, std::int64_t now);

 private:
  // An outlet's count of its samples, from its start-up on.
  struct Life {
    std::uint64_t newest_sample = 0;
    std::int64_t heard_tick = 0;  // of the source
    bool over = false;
  };

  std::vector<record::OutletRecord>& outlets_;
  std::vector<Life> lives_;
  std::int64_t sample_rate_hz_;
};

}  // namespace gsbench::station

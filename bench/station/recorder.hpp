// Puts what a run captures into its store while it is played.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <capture/capture.hpp>
#include <record/run_record.hpp>
#include <record/store.hpp>
#include <station/played_signal.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// All members throw record::StoreError.
class Recorder {
 public:
  // All arguments outlive the recorder.
  Recorder(record::Store& store, const Station& station, const PlayedSignal& signal,
           capture::Capture& capture, record::RunRecord& run);

  // The outlets have been claimed.
  void add_outlets();
  // The source has reached this tick of its own. Stores what has come in the meantime, if it is
  // time: every half second in real time. Aligns the clocks of the outlets as soon as the dips
  // before the run have been reported, so that the record of a run that is killed can be read.
  void reached(std::int64_t tick);
  // Stores what has come since.
  void finish();

 private:
  void append();
  void align_early(std::int64_t tick);
  void update_changed();

  record::Store& store_;
  const Station& station_;
  const PlayedSignal& signal_;
  capture::Capture& capture_;
  record::RunRecord& run_;
  std::int64_t period_ticks_;
  std::int64_t next_tick_ = 0;
  std::vector<std::string> stored_;  // what may change during the run, as it is stored
};

}  // namespace gsbench::station

#include "head_relay_sense.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::head {

using drivers::Done;
using drivers::Error;
using drivers::Status;

relay::Alignment HeadRelaySense::alignment() const {
  const bool is_known = session_->hello.counts_per_sample > 0;
  const double counts_per_tick = is_known ? session_->hello.counts_per_sample : 1.0;
  relay::Alignment alignment;
  alignment.count_at_tick_0 =
      static_cast<double>(session_->tick_0_sample.value_or(0)) * counts_per_tick;
  alignment.counts_per_tick = counts_per_tick;
  // One count; the opto-coupler; half a tick, because an edge is put on a whole one.
  alignment.uncertainty_ticks = (is_known ? 1.0 / counts_per_tick : 0.0) +
                                session_->options.opto_uncertainty_s * protocol::kSampleRate_hz +
                                0.5;
  return alignment;
}

std::string HeadRelaySense::not_known_yet() const {
  return session_->hello.counts_per_sample > 0 ? "" : "one count of the head's timer";
}

// When the contact moved.
std::int64_t HeadRelaySense::contact_count(const protocol::Edge& edge) const {
  const double delay_s =
      edge.closed ? session_->options.opto_close_delay_s : session_->options.opto_open_delay_s;
  return edge.count - std::llround(delay_s * protocol::kSampleRate_hz *
                                   static_cast<double>(session_->hello.counts_per_sample));
}

Status HeadRelaySense::poll(std::vector<relay::Edge>& edges) {
  if (!session_->is_armed() || !session_->tick_0_sample) {
    return Done{};
  }
  if (Status heard = session_->listen(Clock::now()); !heard.ok()) {
    return heard;
  }
  if (run_ != session_->run) {
    begin_run();
  }
  session_->connection.edges().move_to(waiting_);
  open_inputs_reported_ = open_inputs_reported_ || append_open_inputs(edges);
  if (open_inputs_reported_) {
    for (const gs::head::Edge& edge : waiting_) {
      edges.push_back({edge.input, contact_count(edge), edge.closed});
    }
    waiting_.clear();
  }
  const std::uint32_t missed = session_->connection.status()->edges_missed - missed_before_;
  if (missed > 0) {
    return Error{
        fmt::format("{}: the head missed {} edges of its inputs: they were too close "
                    "together to be measured",
                    session_->options.port, missed)};
  }
  return Done{};
}

void HeadRelaySense::begin_run() {
  run_ = session_->run;
  open_inputs_reported_ = false;
  missed_before_ = session_->missed_at_arm;
  waiting_.clear();
}

bool HeadRelaySense::append_open_inputs(std::vector<relay::Edge>& edges) const {
  const protocol::Status& status = *session_->connection.status();
  if (waiting_.size() < status.edges) {
    return false;
  }
  for (std::uint8_t input = 0; input < session_->hello.inputs; ++input) {
    const auto end = waiting_.begin() + status.edges;
    const auto first = std::find_if(
        waiting_.begin(), end, [input](const protocol::Edge& edge) { return edge.input == input; });
    const bool was_open = first != end ? first->closed : (status.closed >> input & 1) == 0;
    if (was_open) {
      // At the beginning of the stream.
      edges.push_back({input, 0, false});
    }
  }
  return true;
}

}  // namespace gsbench::head

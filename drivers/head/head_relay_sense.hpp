// The relay sense of a DAC head: its counts are those of the timer that also clocks the DAC.
#pragma once

#include "session.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <relay/relay_sense.hpp>

namespace gsbench::head {

class HeadRelaySense final : public relay::RelaySense {
 public:
  explicit HeadRelaySense(std::shared_ptr<Session> session) : session_(std::move(session)) {}

  relay::Alignment alignment() const override;
  std::string not_known_yet() const override;
  drivers::Status poll(std::vector<relay::Edge>& edges) override;

 private:
  void begin_run();
  std::int64_t contact_count(const gs::head::Edge& edge) const;
  // An edge for each input that was open at the beginning of the stream. Returns false if it is not
  // known yet.
  bool append_open_inputs(std::vector<relay::Edge>& edges) const;

  std::shared_ptr<Session> session_;
  std::optional<std::uint32_t> run_;
  bool open_inputs_reported_ = false;
  std::uint32_t missed_before_ = 0;
  std::vector<gs::head::Edge> waiting_;  // for start()
};

}  // namespace gsbench::head

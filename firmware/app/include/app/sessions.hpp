// The sessions of the centres that an outlet talks to: their numbers, and the order of their
// messages (wire/README.md, "Starts and sessions").
#pragma once

#include <cstddef>
#include <cstdint>

#include <wire/frame.hpp>

namespace gs::app {

struct Session {
  std::uint32_t number = wire::kNoSession;
  wire::Sequence received;
  std::uint32_t newest_request = 0;  // of its commands; 0: none
};

constexpr std::size_t kSessions = 4;
constexpr std::size_t kPastSessions = 16;

class Sessions {
 public:
  // Null: no identify has begun this session, or others have replaced it.
  Session* find(std::uint32_t number);
  // Begins a session in place of the one that is used the longest ago.
  Session& begin(std::uint32_t number);
  // Notes the use of a session. Pointers to sessions are then invalid; returns the new place.
  Session& use(Session& session);

 private:
  // So that a command of a session that was replaced is not carried out again if it is repeated.
  struct Past {
    std::uint32_t number = wire::kNoSession;
    std::uint32_t newest_request = 0;
  };

  void keep_request(const Session& replaced);
  std::uint32_t kept_request(std::uint32_t number) const;

  Session sessions_[kSessions];  // used last first
  Past past_[kPastSessions];     // replaced last first; only those with a request
};

}  // namespace gs::app

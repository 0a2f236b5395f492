#include <app/sessions.hpp>

namespace gs::app {

Session* Sessions::find(std::uint32_t number) {
  for (Session& session : sessions_) {
    if (session.number == number && number != wire::kNoSession) {
      return &session;
    }
  }
  return nullptr;
}

Session& Sessions::begin(std::uint32_t number) {
  Session& oldest = sessions_[kSessions - 1];
  keep_request(oldest);
  oldest = Session{};
  oldest.number = number;
  oldest.newest_request = kept_request(number);
  return oldest;
}

void Sessions::keep_request(const Session& replaced) {
  if (replaced.newest_request == 0) {
    return;
  }
  for (Past& past : past_) {
    if (past.number == replaced.number) {
      past.newest_request = replaced.newest_request;
      return;
    }
  }
  past_[next_past_].number = replaced.number;
  past_[next_past_].newest_request = replaced.newest_request;
  next_past_ = (next_past_ + 1) % kPastSessions;
}

std::uint32_t Sessions::kept_request(std::uint32_t number) const {
  for (const Past& past : past_) {
    if (past.number == number) {
      return past.newest_request;
    }
  }
  return 0;
}

Session& Sessions::use(Session& session) {
  const Session used = session;
  for (Session* place = &session; place != sessions_; --place) {
    *place = *(place - 1);
  }
  sessions_[0] = used;
  return sessions_[0];
}

}  // namespace gs::app

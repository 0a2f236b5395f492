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
  const std::uint32_t newest_request = kept_request(number);
  keep_request(oldest);  // in place of another one, perhaps of this session's
  oldest = Session{};
  oldest.number = number;
  oldest.newest_request = newest_request;
  return oldest;
}

void Sessions::keep_request(const Session& replaced) {
  if (replaced.newest_request == 0) {
    return;
  }
  std::size_t place = 0;  // its own, or that of the oldest
  while (place + 1 < kPastSessions && past_[place].number != replaced.number) {
    ++place;
  }
  for (; place > 0; --place) {
    past_[place] = past_[place - 1];
  }
  past_[0] = {replaced.number, replaced.newest_request};
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

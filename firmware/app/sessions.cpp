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
  oldest = Session{};
  oldest.number = number;
  return oldest;
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

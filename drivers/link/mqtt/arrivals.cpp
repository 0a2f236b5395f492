#include "arrivals.hpp"

#include <algorithm>
#include <cstdio>

#include <link/version_text.hpp>

namespace gsbench::link {

namespace {

// Two outlets with one id answer within a round trip or two of each other.
constexpr auto kTimeForATwin = std::chrono::milliseconds(200);

constexpr std::string_view kPrefix = "gs/";
constexpr std::string_view kHello = "/hello";

std::string piece(std::uint32_t instance) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08X", static_cast<unsigned>(instance));
  return text;
}

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

std::string hello_topic(const std::string& id) {
  return "gs/" + id + "/hello";
}
std::string up_topic(const std::string& id) {
  return "gs/" + id + "/up";
}
std::string down_topic(const std::string& id) {
  return "gs/" + id + "/down";
}

void Arrivals::take(std::string_view topic, const std::uint8_t* message, std::size_t size,
                    bool retained) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = places_.find(topic);
  if (found == places_.end()) {
    take_candidate(topic, size);
  } else if (outlets_[found->second.outlet].left_out) {
    return;
  } else if (found->second.hello) {
    take_hello(found->second.outlet, message, size, retained);
  } else if (outlets_[found->second.outlet].said_hello) {
    take_message(found->second.outlet, message, size);
  }
}

void Arrivals::take_candidate(std::string_view topic, std::size_t size) {
  const std::size_t around = kPrefix.size() + kHello.size();
  if (topic.size() <= around || topic.substr(0, kPrefix.size()) != kPrefix ||
      topic.substr(topic.size() - kHello.size()) != kHello) {
    return;
  }
  candidates_[std::string(topic.substr(kPrefix.size(), topic.size() - around))] = size > 0;
  changed_.notify_all();
}

void Arrivals::take_hello(std::size_t place, const std::uint8_t* message, std::size_t size,
                          bool retained) {
  Outlet& outlet = outlets_[place];
  if (size == 0) {
    outlet.here = false;
    outlet.stream.note("left the broker");
    return;
  }
  // What the broker had kept is news only where it is another one than the last that came.
  const bool known =
      std::equal(message, message + size, outlet.last_hello.begin(), outlet.last_hello.end());
  if (retained && (known || !outlet.said_hello)) {
    return;
  }
  gs::wire::Uplink read;
  std::uint32_t sequence = 0;
  if (gs::wire::decode(message, size, read, sequence) == gs::wire::Decoded::kOk &&
      read.kind == gs::wire::UplinkKind::kHello && !take_identity(outlet, read.hello)) {
    return;
  }
  outlet.here = true;
  outlet.last_hello.assign(message, message + size);
  take_message(place, message, size);
}

// Before its number is looked at: that of another outlet means nothing. False where it is
// another's.
bool Arrivals::take_identity(Outlet& outlet, const gs::wire::Hello& hello) {
  std::string trouble;
  if (hello.id != outlet.id) {
    trouble = "says there that it is \"" + std::string(hello.id) + '"';
  } else if (outlet.said_hello && hello.instance != outlet.hello.instance) {
    trouble = "is there twice: " + piece(outlet.hello.instance) + " and " + piece(hello.instance) +
              " say that they are it";
  }
  if (!trouble.empty()) {
    outlet.trouble = trouble;
    outlet.stream.note(trouble);
    return false;
  }
  if (!outlet.said_hello) {
    outlet.said_hello = true;
    outlet.hello = hello;
    --silent_;
    changed_.notify_all();
  }
  return true;
}

void Arrivals::take_message(std::size_t place, const std::uint8_t* message, std::size_t size) {
  const auto read = outlets_[place].stream.take(message, size);
  if (read) {
    received_.push_back({place, *read, now_ns()});
  }
}

std::vector<std::string> Arrivals::wait_for_hellos(const std::vector<std::string>& wanted,
                                                   Deadline until) {
  std::unique_lock<std::mutex> lock(mutex_);
  const auto here = [this](const std::string& id) {
    const auto found = candidates_.find(id);
    return found != candidates_.end() && found->second;
  };
  changed_.wait_until(lock, until, [&] {
    return !wanted.empty() && std::all_of(wanted.begin(), wanted.end(), here);
  });
  std::vector<std::string> ids;
  for (const auto& [id, present] : candidates_) {
    if (present) {
      ids.push_back(id);
    }
  }
  return ids;
}

void Arrivals::expect(const std::vector<std::string>& ids) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::string& id : ids) {
    Outlet& outlet = outlets_.emplace_back();
    outlet.id = id;
    outlet.hello_topic = hello_topic(id);
    outlet.up_topic = up_topic(id);
    const std::size_t place = outlets_.size() - 1;
    places_[outlet.hello_topic] = {place, true};
    places_[outlet.up_topic] = {place, false};
  }
  silent_ = outlets_.size();
}

void Arrivals::leave_out(std::size_t outlet, const std::string& fault) {
  const std::lock_guard<std::mutex> lock(mutex_);
  outlets_[outlet].trouble = fault;
  outlets_[outlet].left_out = true;
  --silent_;
}

void Arrivals::wait_for_answers(Deadline until) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (changed_.wait_until(lock, until, [this] { return silent_ == 0; })) {
    changed_.wait_for(lock, kTimeForATwin, [] { return false; });
  }
}

std::vector<OutletPresence> Arrivals::settle() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<OutletPresence> all;
  for (Outlet& outlet : outlets_) {
    const auto faults = outlet.stream.take_faults();
    if (!outlet.said_hello && outlet.trouble.empty()) {
      outlet.trouble = faults.empty() ? "does not answer" : faults.front();
    }
    if (outlet.trouble.empty()) {
      outlet.trouble = protocol_fault(outlet.hello);
    }
    outlet.left_out = !outlet.trouble.empty();
    all.push_back({outlet.id, "", outlet.hello, outlet.trouble});
  }
  received_.clear();
  return all;
}

std::vector<std::uint8_t> Arrivals::encode(std::size_t outlet, const gs::wire::Downlink& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (outlets_[outlet].left_out) {
    return {};
  }
  if (!outlets_[outlet].here) {
    outlets_[outlet].stream.note("was not sent a message: it is not on the broker");
    return {};
  }
  return outlets_[outlet].stream.encode(message);
}

void Arrivals::note(std::size_t outlet, const std::string& fault) {
  const std::lock_guard<std::mutex> lock(mutex_);
  outlets_[outlet].stream.note(fault);
}

void Arrivals::note_all(const std::string& fault) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (Outlet& outlet : outlets_) {
    outlet.stream.note(fault);
  }
}

void Arrivals::hand_over(std::vector<Received>& messages, std::vector<Fault>& faults) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (messages.empty()) {
    messages.swap(received_);
  } else {
    messages.insert(messages.end(), received_.begin(), received_.end());
  }
  received_.clear();
  for (std::size_t place = 0; place < outlets_.size(); ++place) {
    Outlet& outlet = outlets_[place];
    for (std::string& fault : outlet.stream.take_faults()) {
      if (!outlet.left_out) {
        faults.push_back({place, std::move(fault)});
      }
    }
  }
}

}  // namespace gsbench::link

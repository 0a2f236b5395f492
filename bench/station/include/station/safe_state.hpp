// A guard whose destructor switches the source off and closes the links, so that every end of a
// run, also by an exception, leaves the station in its safe state.
#pragma once

#include <string>

#include <link/link.hpp>
#include <source/source.hpp>

namespace gsbench::station {

// What a user must know if a source could not be made safe.
inline std::string unknown_state(const std::string& error) {
  const std::string known = "output state unknown";
  const std::string sentence =
      !error.empty() && error.back() == '.' ? error.substr(0, error.size() - 1) : error;
  return (error.find(known) == std::string::npos ? known + ": " : "") + sentence +
         ". The outlets may be live: switch the source off by hand, or unplug it.";
}

class SafeState {
 public:
  // If the source cannot be made safe, the destructor appends the reason to `fault`.
  SafeState(source::Source& source, link::Link& link, std::string& fault)
      : source_(source), link_(link), fault_(fault) {}
  ~SafeState() {
    const drivers::Status safe = source_.make_safe();
    link_.close();
    if (!safe.ok()) {
      fault_ += (fault_.empty() ? "" : "; ") + unknown_state(safe.error());
    }
  }
  SafeState(const SafeState&) = delete;
  SafeState& operator=(const SafeState&) = delete;

 private:
  source::Source& source_;
  link::Link& link_;
  std::string& fault_;
};

}  // namespace gsbench::station

// A guard whose destructor switches the source off and closes the links, so that every end of a
// run, also by an exception, leaves the station in its safe state.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include <link/link.hpp>
#include <source/source.hpp>

namespace gsbench::station {

// What a user must know if a source could not be made safe.
inline std::string unknown_state(const std::string& error) {
  const std::string known = "output state unknown";
  const std::string sentence =
      !error.empty() && error.back() == '.' ? error.substr(0, error.size() - 1) : error;
  const bool has_advice = error.find("by hand") != std::string::npos;
  return (error.find(known) == std::string::npos ? known + ": " : "") + sentence +
         (has_advice ? ". The outlets may be live."
                     : ". The outlets may be live: switch the source off by hand, or unplug it.");
}

class SafeState {
 public:
  // If the source cannot be made safe, the destructor calls `report` with what a user must know,
  // if there is such a function, and appends that to `fault`.
  SafeState(source::Source& source, link::Link& link, std::string& fault,
            std::function<void(const std::string& what)> report = {})
      : source_(source), link_(link), fault_(fault), report_(std::move(report)) {}
  ~SafeState() {
    const drivers::Status safe = source_.make_safe();
    link_.close();
    if (!safe.ok()) {
      const std::string what = unknown_state(safe.error());
      if (report_) {
        report_(what);
      }
      fault_ += (fault_.empty() ? "" : "; ") + what;
    }
  }
  SafeState(const SafeState&) = delete;
  SafeState& operator=(const SafeState&) = delete;

 private:
  source::Source& source_;
  link::Link& link_;
  std::string& fault_;
  std::function<void(const std::string&)> report_;
};

}  // namespace gsbench::station

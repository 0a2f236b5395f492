// Source off, outlets' links closed: reached on every way out of a run, an exception's among them.
#pragma once

#include <string>

#include <link/link.hpp>
#include <source/source.hpp>

namespace gsbench::station {

class SafeState {
 public:
  // `fault` gets why the source is not in its safe state, where it is not.
  SafeState(source::Source& source, link::Link& link, std::string& fault)
      : source_(source), link_(link), fault_(fault) {}
  ~SafeState() {
    const drivers::Status safe = source_.make_safe();
    link_.close();
    if (!safe.ok()) {
      fault_ += (fault_.empty() ? "" : "; ") + ("the source may still be live: " + safe.error());
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

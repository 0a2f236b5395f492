// Source off, outlets' links closed: reached on every way out of a run, an exception's among them.
#pragma once

#include <link/link.hpp>
#include <source/source.hpp>

namespace gsbench::station {

class SafeState {
 public:
  SafeState(source::Source& source, link::Link& link) : source_(source), link_(link) {}
  ~SafeState();
  SafeState(const SafeState&) = delete;
  SafeState& operator=(const SafeState&) = delete;

 private:
  source::Source& source_;
  link::Link& link_;
};

}  // namespace gsbench::station

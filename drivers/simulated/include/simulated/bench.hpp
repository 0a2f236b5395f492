// A simulated bench in one process: source, outlets that run the real firmware, link and relay
// sense, behind the three driver interfaces. The three share state: use them from one thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <relay/relay_sense.hpp>
#include <simulated/outlet.hpp>
#include <simulated/pacer.hpp>
#include <source/source.hpp>

namespace gsbench::simulated {

struct BenchParameters {
  std::vector<std::string> outlet_ids;
  OutletParameters outlet;
  Pace pace = Pace::kVirtual;
  std::size_t threads = 1;
};

class Bench {
 public:
  explicit Bench(const BenchParameters& parameters);

  // Owned by the bench.
  source::Source& source() { return *source_; }
  link::Link& link() { return *link_; }
  relay::RelaySense& relay_sense() { return *relay_sense_; }

 private:
  std::unique_ptr<source::Source> source_;
  std::unique_ptr<link::Link> link_;
  std::unique_ptr<relay::RelaySense> relay_sense_;
};

}  // namespace gsbench::simulated

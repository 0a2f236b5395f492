// Several links as one. An empty list gives a link without outlets.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>

namespace gsbench::link {

class CombinedLink final : public Link {
 public:
  explicit CombinedLink(std::vector<std::unique_ptr<Link>> links) : links_(std::move(links)) {}

  [[nodiscard]] drivers::Status open() override;
  [[nodiscard]] drivers::Status send(const std::string& id,
                                     const gs::wire::Downlink& message) override;
  [[nodiscard]] drivers::Status poll(Happenings& happenings) override;
  std::vector<Fault> missing() override;
  std::vector<Fault> unreachable() override;
  void close() noexcept override;

 private:
  std::vector<Fault> of_all(std::vector<Fault> (Link::*faults)());

  std::vector<std::unique_ptr<Link>> links_;
  std::map<std::string, Link*> link_of_;  // by the ids of the outlets that have joined
};

}  // namespace gsbench::link

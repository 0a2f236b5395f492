// Several links as one: the outlets of the first, then those of the second, and so on.
#pragma once

#include <memory>
#include <vector>

#include <link/link.hpp>

namespace gsbench::link {

class CombinedLink final : public Link {
 public:
  explicit CombinedLink(std::vector<std::unique_ptr<Link>> links) : links_(std::move(links)) {}

  std::string name() const override;
  // Outlets of one id on two links are at fault.
  [[nodiscard]] drivers::Result<std::vector<OutletPresence>> open() override;
  [[nodiscard]] drivers::Status send(std::size_t outlet,
                                     const gs::wire::Downlink& message) override;
  [[nodiscard]] drivers::Status poll(std::vector<Received>& messages,
                                     std::vector<Fault>& faults) override;
  void close() noexcept override;

 private:
  std::vector<std::unique_ptr<Link>> links_;
  std::vector<std::size_t> first_;  // outlet of each link; one more: the end
  std::vector<bool> at_fault_;
};

}  // namespace gsbench::link

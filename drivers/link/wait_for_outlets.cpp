#include <algorithm>
#include <set>
#include <thread>
#include <utility>

#include <link/wait_for_outlets.hpp>

namespace gsbench::link {
namespace {

constexpr auto kBetweenLooks = std::chrono::milliseconds(2);
// Two outlets with the same id answer within one or two round trips of each other.
constexpr auto kTimeForATwin = std::chrono::milliseconds(200);

class RollCall {
 public:
  explicit RollCall(const std::vector<std::string>& named) : named_(named) {}

  void take(const Happenings& happenings) {
    for (const Change& change : happenings.changes) {
      if (const auto* const joined = std::get_if<OutletPresence>(&change)) {
        join(*joined);
      } else {
        leave(std::get<Fault>(change));
      }
    }
    faults_.insert(faults_.end(), happenings.faults.begin(), happenings.faults.end());
  }

  bool someone_left() const { return someone_left_; }

  std::size_t joined() const {
    return static_cast<std::size_t>(
        std::count_if(named_.begin(), named_.end(), [&](const std::string& name) {
          return std::any_of(joined_.begin(), joined_.end(),
                             [&](const auto& outlet) { return is_called(outlet, name); });
        }));
  }

  // Call once, at the end. `missing`: from Link::missing().
  std::vector<OutletPresence> result(const std::vector<Fault>& missing, bool others) {
    const std::vector<OutletPresence> everyone = joined_;
    faults_.insert(faults_.end(), missing.begin(), missing.end());
    std::vector<OutletPresence> all;
    all.reserve(named_.size());
    for (const std::string& name : named_) {
      all.push_back(take_out(name));
    }
    if (others) {
      all.insert(all.end(), joined_.begin(), joined_.end());
      for (const Fault& fault : missing) {
        if (std::none_of(all.begin(), all.end(),
                         [&](const auto& outlet) { return outlet.id == fault.id; })) {
          all.push_back({fault.id, "", {}, fault.what});
        }
      }
    }
    mark_twins(all, everyone);
    return all;
  }

 private:
  static bool is_same(const OutletPresence& outlet, const std::string& id,
                      const std::string& where) {
    return outlet.id == id && outlet.where == where;
  }

  void join(const OutletPresence& outlet) {
    left_.erase({outlet.id, outlet.where});
    const auto again = std::find_if(joined_.begin(), joined_.end(), [&](const auto& other) {
      return is_same(other, outlet.id, outlet.where);
    });
    if (again != joined_.end()) {
      *again = outlet;
    } else {
      joined_.push_back(outlet);
    }
  }

  void leave(const Fault& left) {
    someone_left_ = true;
    if (!left.excluded) {
      left_.insert({left.id, left.where});
    }
    for (OutletPresence& outlet : joined_) {
      if (is_same(outlet, left.id, left.where) && (outlet.fault.empty() || left.excluded)) {
        outlet.fault = left.what;
      }
    }
  }

  static bool is_called(const OutletPresence& outlet, const std::string& name) {
    return outlet.where == name || outlet.id == name;
  }

  OutletPresence take_out(const std::string& name) {
    const auto found = std::find_if(joined_.begin(), joined_.end(),
                                    [&](const auto& outlet) { return is_called(outlet, name); });
    if (found != joined_.end()) {
      OutletPresence outlet = *found;
      joined_.erase(found);
      return outlet;
    }
    const auto fault = std::find_if(faults_.begin(), faults_.end(),
                                    [&](const Fault& reported) { return reported.id == name; });
    return {name, "", {}, fault != faults_.end() ? fault->what : "does not answer"};
  }

  // One that has left is no twin.
  void mark_twins(std::vector<OutletPresence>& outlets,
                  const std::vector<OutletPresence>& everyone) const {
    const auto is_there = [&](const OutletPresence& outlet) {
      return !outlet.where.empty() && left_.count({outlet.id, outlet.where}) == 0;
    };
    for (OutletPresence& outlet : outlets) {
      const auto twin = std::find_if(everyone.begin(), everyone.end(), [&](const auto& other) {
        return is_there(outlet) && is_there(other) && other.id == outlet.id &&
               other.where != outlet.where;
      });
      if (twin != everyone.end()) {
        outlet.fault = same_id_fault(twin->where);
        outlet.id += " on " + outlet.where;
      }
    }
  }

  const std::vector<std::string>& named_;
  std::vector<OutletPresence> joined_;
  std::set<std::pair<std::string, std::string>> left_;  // ids and places
  std::vector<Fault> faults_;                           // of outlets that may not have joined
  bool someone_left_ = false;
};

}  // namespace

drivers::Result<std::vector<OutletPresence>> wait_for_outlets(
    Link& link, const std::vector<std::string>& named, std::chrono::milliseconds patience,
    std::chrono::milliseconds others_for) {
  if (const drivers::Status opened = link.open(); !opened.ok()) {
    return drivers::Error{opened.error()};
  }
  return wait_on_open_link(link, named, patience, others_for);
}

drivers::Result<std::vector<OutletPresence>> wait_on_open_link(
    Link& link, const std::vector<std::string>& named, std::chrono::milliseconds patience,
    std::chrono::milliseconds others_for, const Meanwhile& meanwhile) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  Clock::time_point end = begin + patience;
  RollCall roll_call(named);
  bool was_complete = false;
  Happenings happenings;
  while (true) {
    happenings.clear();
    drivers::Status going_well = link.poll(happenings);
    roll_call.take(happenings);
    const std::size_t joined = roll_call.joined();
    if (going_well.ok() && meanwhile) {
      going_well = meanwhile(joined);
    }
    if (!going_well.ok()) {
      link.close();
      return drivers::Error{going_well.error()};
    }
    if (!was_complete && joined == named.size()) {
      was_complete = true;
      end = std::min(end, Clock::now() + kTimeForATwin);
    }
    if (roll_call.someone_left()) {
      end = begin + patience;
    }
    if (Clock::now() >= std::max(end, begin + others_for)) {
      return roll_call.result(link.missing(), others_for.count() > 0);
    }
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

}  // namespace gsbench::link

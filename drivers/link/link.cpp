#include <map>

#include <link/link.hpp>

namespace gsbench::link {

void mark_twins(std::vector<OutletPresence>& outlets) {
  std::map<std::string, std::vector<OutletPresence*>> by_id;
  for (OutletPresence& outlet : outlets) {
    if (outlet.hello.id[0] != '\0') {
      by_id[outlet.hello.id].push_back(&outlet);
    }
  }
  for (const auto& [id, same] : by_id) {
    for (std::size_t i = 0; same.size() > 1 && i < same.size(); ++i) {
      same[i]->fault =
          "is there twice: the one on " + same[i == 0 ? 1 : 0]->where + " says that it is it";
      same[i]->id = id + " on " + same[i]->where;
    }
  }
}

}  // namespace gsbench::link

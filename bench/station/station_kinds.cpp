#include "station_kind.hpp"

namespace gsbench::station {

const std::vector<StationKind>& station_kinds() {
  static const std::vector<StationKind> kinds = {simulated_kind(), emulated_kind(),
                                                 physical_kind()};
  return kinds;
}

}  // namespace gsbench::station

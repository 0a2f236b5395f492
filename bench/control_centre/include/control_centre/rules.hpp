// Rules by which the control centre derives an outlet's settings from the grid.
#pragma once

#include <cstdint>

namespace gsbench::control_centre {

enum class Rules : std::uint8_t {
  kGsbench,  // threshold loss that allows for the outlets' delay; f^B in stages
  kPaper,    // threshold loss by eq. (15); f^B by eq. (17)
};

}  // namespace gsbench::control_centre

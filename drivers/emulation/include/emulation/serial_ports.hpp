// Pseudo-terminals as serial ports, for this process: libserialport opens none by itself.
#pragma once

#include <drivers/result.hpp>

namespace gsbench::emulation {

// Does libserialport take pseudo-terminals here?
bool pseudo_terminals_are_serial_ports();

// Begins this program anew, with its arguments, so that it does. Returns only where it cannot.
drivers::Status restart_with_pseudo_terminals();

}  // namespace gsbench::emulation

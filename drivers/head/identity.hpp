// Whether a head is one that the driver can use.
#pragma once

#include <head_driver/head.hpp>

#include <string>

#include <drivers/result.hpp>
#include <head/messages.hpp>

namespace gsbench::head {

// An error, which names the port and the difference, if the head has another protocol version,
// another stream, another full scale than the options state, or no accurate clock.
drivers::Status check(const gs::head::Hello& hello, const HeadOptions& options);

}  // namespace gsbench::head

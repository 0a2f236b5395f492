// A message as one line for people.
#pragma once

#include <string>

#include <wire/messages.hpp>

namespace gsbench::cli {

std::string message_text(const std::string& outlet, const gs::wire::Uplink& message);

}  // namespace gsbench::cli

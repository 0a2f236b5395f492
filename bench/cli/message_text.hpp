// Outlets and their messages as text and as JSON.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include <link/link.hpp>
#include <wire/messages.hpp>

namespace gsbench::cli {

// What a message says, without its kind.
std::string details(const gs::wire::Uplink& message);

// The fields of a message with their units. A number that is not one is null.
nlohmann::ordered_json fields_of(const gs::wire::Uplink& message);

// What is known of an outlet: only where it was expected and its fault, if it did not answer; the
// identity if it has another version of the protocol. `answered`: it has sent a hello.
nlohmann::ordered_json as_json(const link::OutletPresence& outlet, bool answered);

}  // namespace gsbench::cli

// Small messages leave when they are written, not when the broker has acknowledged the one before:
// without that, each other command waits for 40 ms. Paho has no option for it and gives out no
// socket, so that this process's connections to the broker's port are looked for.
#pragma once

#include <string>

namespace gsbench::link {

void send_at_once(const std::string& url);

}  // namespace gsbench::link

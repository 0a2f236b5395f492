// SIGINT and SIGTERM ask a run to end in its safe state; a second one ends the process as usual.
#pragma once

#include <atomic>

namespace gsbench::cli {

const std::atomic<bool>& catch_interrupts();

}  // namespace gsbench::cli

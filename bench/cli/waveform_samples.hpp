// What a profile plays as CSV, a line a sample.
#pragma once

#include "output_file.hpp"

#include <atomic>

#include <profile/plan.hpp>

namespace gsbench::cli {

// As the first outlet of a simulated station gets it. False where it was interrupted.
bool write_samples(const profile::Plan& plan, const std::atomic<bool>& interrupted,
                   OutputFile& file);

}  // namespace gsbench::cli

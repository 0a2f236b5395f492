// The signal of a profile as CSV, one line per sample.
#pragma once

#include "output_file.hpp"

#include <atomic>

#include <profile/plan.hpp>

namespace gsbench::cli {

// Writes the samples with the noise of the first outlet of a simulated station. Returns false if
// interrupted.
// Throws render::WriteError.
bool write_samples(const profile::Plan& plan, const std::atomic<bool>& interrupted,
                   OutputFile& file);

}  // namespace gsbench::cli

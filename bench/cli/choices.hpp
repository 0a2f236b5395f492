// Options that choose one of a few by name.
#pragma once

#include <CLI/CLI.hpp>

#include <campaign/estimates.hpp>

namespace gsbench::cli {

void add_noise_law(CLI::App& command, campaign::NoiseLaw& law);            // --noise-law
void add_loss_instant(CLI::App& command, campaign::LossInstant& instant);  // --loss-instant

}  // namespace gsbench::cli

// Options that choose one of a few by name.
#pragma once

#include <control_centre/blocks.hpp>

#include <CLI/CLI.hpp>

#include <campaign/estimates.hpp>

namespace gsbench::cli {

void add_noise_distribution(CLI::App& command,
                            campaign::NoiseDistribution& distribution);  // --noise-distribution
void add_accumulation(CLI::App& command,
                      control_centre::Accumulation& accumulation);         // --accumulated
void add_loss_instant(CLI::App& command, campaign::LossInstant& instant);  // --loss-instant

}  // namespace gsbench::cli

// Options that choose one of a few by name.
#pragma once

#include "arguments.hpp"
#include <control_centre/blocks.hpp>

#include <campaign/estimates.hpp>

namespace gsbench::cli {

void add_noise_distribution(const Command& command,
                            campaign::NoiseDistribution& distribution);  // --noise-distribution
void add_accumulation(const Command& command,
                      control_centre::Accumulation& accumulation);              // --accumulated
void add_loss_instant(const Command& command, campaign::LossInstant& instant);  // --loss-instant

}  // namespace gsbench::cli

// Noise of many streams at once, for trajectories that are computed side by side.
#pragma once

#include <models/noise.hpp>

namespace gsbench::models {

// out[sample·streams + i] += value `sample` of stream first.index + i: uniform within ±half_width.
// A stream is asked for uniform or for Gaussian values, not for both.
void add_uniform_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                         float half_width, float* out);
// The same of N(0, sigma²): the values that add_gaussian() gives.
void add_gaussian_to_each(const Stream& first, std::size_t streams, std::size_t samples,
                          float sigma, float* out);

}  // namespace gsbench::models

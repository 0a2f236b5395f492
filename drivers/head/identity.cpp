#include "identity.hpp"

#include <cmath>

#include <fmt/format.h>

#include <head/interpolator.hpp>

namespace gsbench::head {

using drivers::Done;
using drivers::Error;
using drivers::Status;

namespace {

// The reference voltage of a board is accurate to some per cent.
constexpr double kFullScaleTolerance = 0.05;

template <class Value>
Status require(const std::string& port, const char* what, Value has, Value needed) {
  return has == needed ? Status(Done{})
                       : Error{fmt::format("{}: the head's {} is {}; this bench needs {}", port,
                                           what, has, needed)};
}

}  // namespace

Status check(const gs::head::Hello& hello, const HeadOptions& options) {
  const std::string& port = options.port;
  for (const Status& same :
       {require(port, "protocol version", int{hello.protocol_version},
                int{gs::head::kProtocolVersion}),
        require(port, "sample rate in Hz", hello.sample_rate_hz, gs::head::kSampleRate_hz),
        require(port, "number of codes for each sample", std::uint32_t{hello.oversampling},
                gs::head::kOversampling),
        require(port, "resolution in bits", int{hello.dac_bits}, 12),
        require(port, "largest sample", int{hello.full_scale}, int{gs::head::kFullScale})}) {
    if (!same.ok()) {
      return same;
    }
  }
  if (hello.counts_per_sample == 0 || hello.inputs > gs::head::kInputs) {
    return Error{fmt::format("{}: the head states {} counts for each sample and {} inputs", port,
                             hello.counts_per_sample, hello.inputs)};
  }
  if ((hello.flags & gs::head::kCrystalRuns) == 0) {
    return Error{port + ": the head's crystal does not run: its clock is accurate to 1 % only"};
  }
  const double full_scale_v = 1e-3 * hello.full_scale_mv;
  if (std::fabs(full_scale_v / options.dac_full_scale_v - 1.0) > kFullScaleTolerance) {
    return Error{fmt::format("{}: the head's full scale is {} V; the station states {} V", port,
                             full_scale_v, options.dac_full_scale_v)};
  }
  return Done{};
}

}  // namespace gsbench::head

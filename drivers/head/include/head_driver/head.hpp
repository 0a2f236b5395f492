// A DAC head (firmware/head): source and relay sense in one board, with one connection and one
// clock. The bench streams samples, 0.15 s ahead of what the head plays. If the bench falls silent,
// the head switches its output off within 203 ms of the last message.
//
// Source and relay sense share the connection: use them from one thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include <drivers/result.hpp>
#include <relay/relay_sense.hpp>
#include <source/source.hpp>
#include <transport/transport.hpp>

namespace gsbench::head {

struct HeadOptions {
  std::string port;  // for transport::make_transport()
  int baud = transport::kBaud;

  double nominal_v = 230.0;         // RMS at the outlets
  double gain = 260.0;              // V at the outlets for 1 V at the DAC's pin
  double dac_full_scale_v = 1.444;  // largest deviation from mid-scale at the DAC's pin
  double voltage_limit_v = 265.0;   // RMS at the outlets; √2 times this is the largest peak
  double clock_ppm = 30.0;          // accuracy of the board's crystal, ±

  // The delays of the opto-couplers between contact and input. The uncertainty is that of both, ±.
  double opto_close_delay_s = 5e-6;
  double opto_open_delay_s = 35e-6;
  double opto_uncertainty_s = 20e-6;
};

struct Session;

class Head {
 public:
  // An error if an option is out of range, or nominal voltage is beyond the DAC's full scale or the
  // voltage limit. Does not open the port: the source connects in prepare() or make_safe().
  static drivers::Result<std::unique_ptr<Head>> create(const HeadOptions& options);
  ~Head();

  // Blocking: prepare() 1.5 s at most, energise() about 0.6 s, make_safe() 2.5 s at most. Owned by
  // this object.
  source::Source& source() { return *source_; }

  // Channel i is input i of the head. Reports no edges before the source's start(). Owned by this
  // object.
  relay::RelaySense& relay_sense() { return *relay_sense_; }

 private:
  explicit Head(const HeadOptions& options);

  std::shared_ptr<Session> session_;
  std::unique_ptr<source::Source> source_;
  std::unique_ptr<relay::RelaySense> relay_sense_;
};

}  // namespace gsbench::head

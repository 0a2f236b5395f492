// A waveform generator that speaks SCPI, over TCP or a serial port (Kind::kLoaded). Every setting
// is asked back after it was sent. While the waveform plays, the settings are asked in turn, each
// about four times a second, or as often as the instrument answers.
#pragma once

#include <source_scpi/instrument.hpp>
#include <source_scpi/planner.hpp>

#include <memory>
#include <string>

#include <source/source.hpp>
#include <transport/transport.hpp>

namespace gsbench::scpi {

struct SourceOptions {
  std::string port;  // for transport::make_transport(): "tcp://192.168.1.5:5025", "/dev/ttyUSB0"
  int baud = 115200;
  int channel = 1;
  PlanOptions plan;
  // How long make_safe() tries to reach an instrument that does not answer, before it reports that
  // the state of the output is unknown.
  double make_safe_s = 10.0;
  double check_every_s = 0.25;  // each setting, while playing; shorter only for tests
};

// Opens and sends nothing before prepare() or make_safe(); the latter needs no prepare(). Blocking:
// - prepare(): for the upload, about 1 s for each MB, and the pauses of the instrument
// - energise(): while the voltage rises
// - start(): until tick 0
// - stop(), make_safe(): until the instrument answers that its output is off; make_safe_s at most
std::unique_ptr<source::Source> make_scpi_source(Instrument instrument, SourceOptions options);

}  // namespace gsbench::scpi

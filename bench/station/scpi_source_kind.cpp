// The source of kind "scpi": a waveform generator.
#include "port_keys.hpp"
#include "source_kind.hpp"
#include <source_scpi/scpi_source.hpp>

#include <station/instrument_file.hpp>

namespace gsbench::station {
namespace {

scpi::Instrument read_instrument_of(const keys::Table& source, const std::string& file_path) {
  try {
    return load_instrument(source.text("instrument"), file_path);
  } catch (const NoSuchInstrument& error) {
    source.refuse("instrument", error.what());
  }
}

SourceFactory read_scpi(const keys::Table& source, const std::string& file_path) {
  if (!source.has("instrument")) {
    source.refuse_missing("instrument", "instrument = \"siglent-sdg2000x\"");
  }
  scpi::SourceOptions options;
  options.channel = static_cast<int>(source.whole("channel"));
  options.baud = read_baud(source);
  return [instrument = read_instrument_of(source, file_path), options](
             const std::string& port, const SourceSettings& settings) mutable {
    options.port = port;
    options.plan.wiring = {settings.nominal_v, settings.gain, settings.voltage_limit_v};
    options.plan.boot_s = settings.boot_s;
    options.make_safe_s = settings.make_safe_s;
    options.plan.tolerances = {1e-3 * settings.tolerances.frequency_mhz,
                               1e-2 * settings.tolerances.voltage_pct,
                               1e-3 * settings.tolerances.time_ms};
    return BuiltSource{scpi::make_scpi_source(instrument, options), nullptr};
  };
}

}  // namespace

SourceKind scpi_source_kind() {
  const scpi::SourceOptions usual;
  return {"scpi",
          "a waveform generator over TCP or a serial port",
          {keys::text("instrument",
                      "model of the generator: the name of a file in "
                      "[drivers/source/scpi/instruments](../drivers/source/scpi/instruments) or in "
                      "your own folder `instruments`, or a path")
               .or_else("required for `scpi`"),
           keys::whole("channel", "", 1, 4, "output of the generator").by_default(usual.channel),
           keys::whole("baud", "Bd", 1200, 4e6, "of a serial port").by_default(usual.baud)},
          read_scpi};
}

}  // namespace gsbench::station

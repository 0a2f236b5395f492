// The kind "head" of sources and of relay senses: one board, on one connection.
#include "relay_kind.hpp"
#include "source_kind.hpp"
#include <head_driver/head.hpp>

#include <stdexcept>

namespace gsbench::station {
namespace {

constexpr double kHighestDac_v = 10.0;
constexpr double kWorstCrystal_ppm = 10000.0;
constexpr double kLongestOpto_us = 1000.0;

head::HeadOptions wired(head::HeadOptions options, const std::string& port,
                        const SourceSettings& settings) {
  options.port = port;
  options.nominal_v = settings.nominal_v;
  options.gain = settings.gain;
  options.voltage_limit_v = settings.voltage_limit_v;
  return options;
}

SourceFactory read_head(const keys::Table& source, const std::string&) {
  head::HeadOptions options;
  options.dac_full_scale_v = source.number("dac_full_scale_v");
  options.clock_ppm = source.number("clock_ppm");
  options.opto_close_delay_s = 1e-6 * source.number("opto_close_delay_us");
  options.opto_open_delay_s = 1e-6 * source.number("opto_open_delay_us");
  options.opto_uncertainty_s = 1e-6 * source.number("opto_uncertainty_us");
  // The limits of the driver depend on several keys.
  if (const auto usable = head::Head::create(wired(options, "", read_source_settings(source)));
      !usable.ok()) {
    source.refuse("gain", usable.error());
  }
  return [options](const std::string& port, const SourceSettings& settings) {
    auto created = head::Head::create(wired(options, port, settings));
    if (!created.ok()) {
      throw std::runtime_error(created.error());
    }
    const std::shared_ptr<head::Head> head = created.take();
    return BuiltSource{std::shared_ptr<source::Source>(head, &head->source()),
                       std::shared_ptr<relay::RelaySense>(head, &head->relay_sense())};
  };
}

}  // namespace

SourceKind head_source_kind() {
  const head::HeadOptions usual;
  return {"head",
          "a [DAC head](../firmware/head/README.md) on a serial port",
          {keys::number("dac_full_scale_v", "V", {0.0, kHighestDac_v, true},
                        "full scale of the head's DAC: peak voltage at its pin")
               .by_default(usual.dac_full_scale_v),
           keys::number("clock_ppm", "ppm", keys::between(0.0, kWorstCrystal_ppm),
                        "accuracy of the head's crystal, ±")
               .by_default(usual.clock_ppm),
           keys::number("opto_close_delay_us", "µs", keys::between(0.0, kLongestOpto_us),
                        "delay of the head's opto-couplers when a contact closes")
               .by_default(1e6 * usual.opto_close_delay_s),
           keys::number("opto_open_delay_us", "µs", keys::between(0.0, kLongestOpto_us),
                        "delay of the head's opto-couplers when a contact opens")
               .by_default(1e6 * usual.opto_open_delay_s),
           keys::number("opto_uncertainty_us", "µs", keys::between(0.0, kLongestOpto_us),
                        "uncertainty of both delays, ±")
               .by_default(1e6 * usual.opto_uncertainty_s)},
          read_head};
}

RelayKind head_relay_kind() {
  RelayKind kind;
  kind.name = "head";
  kind.meaning = "the inputs of the DAC head that is the source";
  kind.channel = "the number of an input, \"0\" to \"3\"";
  kind.aligned_by = "the head's own clock, which counts its samples";
  kind.is_channel = [](const std::string& channel) {
    return channel.size() == 1 && channel[0] >= '0' && channel[0] <= '3';
  };
  kind.identity = [](const std::string& channel) { return channel; };
  kind.of_source = "head";
  kind.port_of = [](const std::string&) { return std::string(); };
  kind.number_of = [](const std::vector<std::string>& channels, std::size_t i) {
    return static_cast<std::size_t>(channels[i][0] - '0');
  };
  kind.make = [](const std::vector<std::string>&, const BuiltSource& source) {
    return source.relay_sense;
  };
  return kind;
}

}  // namespace gsbench::station

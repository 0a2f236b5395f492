// The shipped stations with a source: true errors of emulated clocks, and interlocks.
#include "plans.hpp"
#include "source_kind.hpp"
#include <head_driver/head.hpp>

#include <cmath>

#include <gmock/gmock.h>

#include <keys/table.hpp>
#include <profile/files.hpp>
#include <station/dry_run.hpp>
#include <station/instrument_file.hpp>
#include <station/played_signal.hpp>
#include <station/station_file.hpp>

namespace gsbench::station::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A shipped station file of one kind.
struct Shipped {
  explicit Shipped(const profile::NamedFile& file)
      : name(file.name),
        path(file.path),
        document(keys::parse_toml(profile::read_file(file.path), file.path)) {}

  bool is_of(const std::string& kind) const {
    for (const keys::Entry& entry : std::get<keys::Entries>(document.root.data)) {
      const auto* text = std::get_if<std::string>(&entry.value.data);
      if (entry.key == "kind" && text != nullptr && *text == kind) {
        return true;
      }
    }
    return false;
  }

  std::string name;
  std::string path;
  keys::Document document;
};

// Calls `check` with the name, path and [source] of each shipped station of this kind that has one.
// Returns their names.
template <class Check>
std::vector<std::string> each_source(const std::string& kind, const Check& check) {
  std::vector<std::string> names;
  for (const profile::NamedFile& file : profile::all_stations()) {
    const Shipped station(file);
    if (!station.is_of(kind)) {
      continue;
    }
    const keys::Table top(station.document, station_keys(kind));
    if (top.has("source")) {
      SCOPED_TRACE(station.path);
      names.push_back(station.name);
      check(top.table("source"), station.path);
    }
  }
  return names;
}

// What the bench believes of the clock of an instrument: from its table, or the head's key.
double stated_ppm(const keys::Table& source, const std::string& path) {
  return source.text("kind") == "head"
             ? source.number("clock_ppm")
             : load_instrument(source.text("instrument"), path).accuracy.clock_ppm;
}

// An emulated clock without an error would show nothing.
TEST(ShippedStations, EmulateClocksWithinTheAccuracyThatIsStatedForThem) {
  EXPECT_THAT(each_source("emulated",
                          [](const keys::Table& source, const std::string& path) {
                            const double stated = stated_ppm(source, path);
                            const double error = std::fabs(source.number("clock_error_ppm"));
                            EXPECT_LE(error, stated);
                            EXPECT_GE(error, 0.5 * stated);
                          }),
              ElementsAre("head-emulated", "scpi-emulated"));
}

// Highest voltage of the instrument itself at the outlets, per unit of nominal.
double full_scale_pu(const keys::Table& source, const std::string& path) {
  constexpr double kSqrt2 = 1.41421356237309505;
  const double peak_v =
      source.text("kind") == "head"
          ? source.number("dac_full_scale_v")
          : 0.5 * load_instrument(source.text("instrument"), path).amplitude.highest_vpp;
  return peak_v * source.number("gain") / kSqrt2 / source.number("nominal_v");
}

std::string error_of(const drivers::Result<source::Played>& played) {
  return played.ok() ? "" : played.error();
}

// Why the source refuses nominal voltage that steps to this level; empty: it does not.
std::string refusal_of_level(const keys::Table& source, const std::string& path, double level_pu) {
  const profile::Plan stepped = plan(1.0, "[[signal.amplitude_step]]\nat_s = 0.5\nlevel_pct = " +
                                              std::to_string(100.0 * level_pu) + "\n");
  SourceSettings settings = read_source_settings(source);
  settings.boot_s = 0.0;
  const BuiltSource built = read_source_factory(source, path)("tcp://127.0.0.1:1", settings);
  const PlayedSignal signal(stepped, false);
  return error_of(built.source->check(signal));
}

TEST(ShippedStations, HaveAnInterlockThatActsBelowTheFullScaleOfTheInstrument) {
  const auto check = [](const keys::Table& source, const std::string& path) {
    const double limit_pu = source.number("voltage_limit_v") / source.number("nominal_v");
    const double most_pu = full_scale_pu(source, path);
    ASSERT_LT(limit_pu, most_pu);
    EXPECT_EQ(refusal_of_level(source, path, 0.998 * limit_pu), "");
    const double beyond_pu = std::min(1.01 * limit_pu, 0.5 * (limit_pu + most_pu));
    EXPECT_THAT(refusal_of_level(source, path, beyond_pu), HasSubstr("the voltage limit"));
  };
  EXPECT_THAT(each_source("emulated", check), ElementsAre("head-emulated", "scpi-emulated"));
  EXPECT_THAT(each_source("physical", check),
              ElementsAre("generator", "generator-contact-only", "head", "head-contact-only"));
}

// As bench/station/README.md has it done with copies of them. There is no file with a password.
TEST(ShippedStations, PassADryRunOfTheProfilesThatTheirGuideNames) {
  const auto slots_of = [](const std::string& station, const std::string& profile) {
    const StationFile file = load_station(station);
    const profile::Plan plan = fit_to_station(file, profile::load_profile(profile));
    const std::unique_ptr<Station> made = file.make_station(plan, {});
    return dry_run(plan, *made).slots.size();
  };
  EXPECT_EQ(slots_of("generator", "paper/loss-500mw"), 2U);
  EXPECT_EQ(slots_of("head", "paper/loss-500mw"), 2U);
  EXPECT_EQ(slots_of("generator-contact-only", "regression/contact-only"), 1U);
  EXPECT_EQ(slots_of("head-contact-only", "regression/contact-only"), 1U);
}

// Hours are left out, and tolerances: they are about other things than the highest voltage.
TEST(ShippedStations, PermitTheVoltageThatShippedProfilesNeed) {
  constexpr std::int64_t kLongest_s = 60;
  const auto check = [](const keys::Table& source, const std::string& path) {
    SourceSettings settings = read_source_settings(source);
    settings.tolerances = {1e3, 100.0, 1e3};
    const BuiltSource built = read_source_factory(source, path)("tcp://127.0.0.1:1", settings);
    std::size_t checked = 0;
    for (const profile::ProfileSummary& listed : profile::list_profiles()) {
      const profile::Plan plan = profile::load_profile(listed.name);
      if (plan.duration_ticks() <= kLongest_s * plan.stimulus.sample_rate_hz) {
        const PlayedSignal signal(plan, true);
        EXPECT_EQ(error_of(built.source->check(signal)), "") << listed.name;
        ++checked;
      }
    }
    EXPECT_GE(checked, 10U);
  };
  EXPECT_EQ(each_source("emulated", check).size(), 2U);
}

}  // namespace
}  // namespace gsbench::station::test

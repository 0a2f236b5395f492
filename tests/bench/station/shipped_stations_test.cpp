// The shipped stations with a source: true errors of emulated clocks.
#include "source_kind.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include <keys/table.hpp>
#include <profile/files.hpp>
#include <station/instrument_file.hpp>
#include <station/station_file.hpp>

namespace gsbench::station::test {
namespace {

using testing::ElementsAre;

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

}  // namespace
}  // namespace gsbench::station::test

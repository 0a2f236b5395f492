// Each declared key of each file is used by a text below and documented. Each mistake is refused at
// its position: a wrong type, a value below or above the range, a misspelt name, a missing key.
#include <profile_test/texts.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <keys/document.hpp>
#include <keys/key.hpp>
#include <profile/files.hpp>
#include <profile/load.hpp>
#include <station/instrument_file.hpp>
#include <station/station_file.hpp>

namespace gsbench::profile::test {
namespace {

using keys::Key;
using keys::Type;
using testing::HasSubstr;
using testing::StartsWith;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The inline grid of a profile, as a grid file.
std::string grid_file() {
  const std::string text = kLossesInPlace;
  const auto from = text.find("[grid.system]");
  return "title = \"All keys of a grid\"\nsource = \"Here\"\n" +
         std::regex_replace(text.substr(from, text.find("[[grid.loss]]") - from),
                            std::regex("grid\\."), "");
}

constexpr const char* kEmulatedStation = R"(title = "all keys of an emulated station"
kind = "emulated"
image = "outlet.elf"
[[outlet]]
id = "a"
board = "host"
link = "mqtt"
crystal_ppm = 20.0
[[outlet]]
id = "b"
board = "frequency-relay"
pickup_hz = 48.8
delay_s = 0.1
)";
constexpr const char* kEmulatedGenerator = R"(title = "all keys of an emulated generator"
kind = "emulated"
[source]
kind = "scpi"
nominal_v = 230.0
gain = 100.0
voltage_limit_v = 253.0
boot_s = 5.0
instrument = "siglent-sdg2000x"
emulates = "sdg1032x"
channel = 1
baud = 115200
clock_error_ppm = 3.0
[relay]
kind = "modem"
[[outlet]]
id = "a"
)";
constexpr const char* kEmulatedHead = R"(title = "all keys of an emulated head"
kind = "emulated"
[source]
kind = "head"
gain = 236.0
voltage_limit_v = 253.0
dac_full_scale_v = 1.4
clock_ppm = 10.0
opto_close_delay_us = 1.0
opto_open_delay_us = 2.0
opto_uncertainty_us = 3.0
[[outlet]]
id = "a"
)";
constexpr const char* kPhysicalStation = R"(title = "all keys of a physical station"
kind = "physical"
[serial]
ports = ["/dev/ttyUSB0"]
baud = 115200
[mqtt]
url = "mqtts://broker.example:8883"
ca_file = "ca.crt"
user = "bench"
password_file = "password"
outlets = ["a"]
)";
constexpr const char* kSlots = R"(title = "all keys of slots"
kind = "physical"
[source]
kind = "scpi"
port = "tcp://127.0.0.1:5025"
nominal_v = 230.0
gain = 100.0
voltage_limit_v = 253.0
boot_s = 20.0
instrument = "siglent-sdg2000x"
channel = 1
baud = 115200
[relay]
kind = "modem"
[[outlet]]
place = "socket-1"
serial_number = "a"
link = "/dev/ttyUSB0"
relay = "/dev/ttyUSB1 CTS"
)";

constexpr const char* kHeadStation = R"(title = "all keys of a DAC head"
kind = "physical"
[source]
kind = "head"
port = "/dev/ttyUSB1"
gain = 247.6
voltage_limit_v = 252.0
dac_full_scale_v = 1.44
clock_ppm = 10.0
opto_close_delay_us = 4.0
opto_open_delay_us = 30.0
opto_uncertainty_us = 15.0
[relay]
kind = "head"
[[outlet]]
place = "socket-1"
relay = "0"
)";

// Each array on one line, without comments: the tests below replace single lines.
std::string on_single_lines(const std::string& text) {
  std::string joined;
  std::istringstream lines(text);
  std::string array;
  for (std::string line; std::getline(lines, line);) {
    line.erase(std::min(line.find('#'), line.size()));
    array += line;
    if (std::count(array.begin(), array.end(), '[') ==
        std::count(array.begin(), array.end(), ']')) {
      joined += array + "\n";
      array.clear();
    }
  }
  return joined;
}

// The shipped instruments together use every key.
std::vector<std::string> instrument_texts() {
  std::vector<std::string> texts;
  for (const NamedFile& file : station::all_instruments()) {
    texts.push_back(on_single_lines(read_file(file.path)));
  }
  return texts;
}

struct File {
  const char* name;
  std::function<const Key&()> declared;
  std::vector<std::string> texts;  // together they use every key
  std::function<void(const std::string& path)> load;
};

void PrintTo(const File& file, std::ostream* stream) {
  *stream << file.name;
}

using Visit = std::function<void(const Key& key, const keys::Entry& entry)>;

// Visits every entry of a document with its declaration.
void walk(const keys::Value& value, const Key& table, const Visit& visit) {
  if (const auto* items = std::get_if<keys::Array>(&value.data)) {
    for (const keys::Value& item : *items) {
      walk(item, table, visit);
    }
    return;
  }
  const auto* entries = std::get_if<keys::Entries>(&value.data);
  if (entries == nullptr) {
    return;  // a name instead of a table
  }
  for (const keys::Entry& entry : *entries) {
    const auto key = std::find_if(table.inner.begin(), table.inner.end(),
                                  [&](const Key& known) { return known.name == entry.key; });
    ASSERT_NE(key, table.inner.end()) << entry.key;
    visit(*key, entry);
    if (keys::is_table(*key)) {
      walk(entry.value, *key, visit);
    }
  }
}

class EveryKey : public testing::TestWithParam<File> {
 protected:
  EveryKey() {
    folder_.write("recording.csv", "t,f,u\n0,50,230\n2,50,230\n4,50,230\n");
    folder_.write("foreign.csv", kForeignCsv);
    folder_.write("outlet.elf", "code");
  }

  std::string refusal_of(const std::string& text) const {
    const std::string path = folder_.write("case.toml", text);
    const std::string message =
        gsbench::test::refusal_of<ConfigurationError>([&] { GetParam().load(path); });
    if (message.empty()) {
      return "";
    }
    EXPECT_THAT(message, StartsWith(path + ":"));
    return message.substr(path.size() + 1);
  }

  // Each value of the texts except tables.
  void for_each_value(
      const std::function<void(const std::string&, const Key&, const keys::Entry&)>& use) const {
    for (const std::string& text : GetParam().texts) {
      walk(keys::parse_toml(text, "").root, GetParam().declared(),
           [&](const Key& key, const keys::Entry& entry) {
             if (!keys::is_table(key)) {
               use(text, key, entry);
             }
           });
    }
  }

  const gsbench::test::TemporaryFolder folder_;
};

// `text` with the rest of a line replaced from the position on.
std::string spoilt(const std::string& text, keys::Position at, const std::string& by) {
  std::istringstream lines(text);
  std::string out;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    out +=
        ++number == at.line ? line.substr(0, static_cast<std::size_t>(at.column) - 1) + by : line;
    out += '\n';
  }
  return out;
}

std::string place(keys::Position at) {
  return fmt::format("{}:{}: ", at.line, at.column);
}

// Values outside the declared range; empty without a range.
std::vector<std::string> out_of_range(const Key& key) {
  std::vector<std::string> values;
  const auto add = [&](double bound, bool open, double outwards) {
    if (!std::isfinite(bound)) {
      return;
    }
    const double beyond = open ? bound : std::nextafter(bound, outwards * kInfinity);
    const std::int64_t next =
        static_cast<std::int64_t>(bound) + static_cast<std::int64_t>(outwards);
    values.push_back(key.type == Type::kWhole ? fmt::format("{}", next)
                                              : fmt::format("{:.17e}", beyond));
  };
  add(key.range.low, key.range.low_open, -1.0);
  add(key.range.high, key.range.high_open, 1.0);
  if (keys::is_number(key)) {
    values.insert(values.end(), {"nan", "inf", "-inf"});
  }
  if (key.type == Type::kChoice) {
    values = {"\"" + key.choices.front() + "x\""};
  }
  if (key.type == Type::kId) {
    values = {"\"a b\"", "\"" + std::string(key.longest + 1, 'a') + "\""};
  }
  return values;
}

TEST_P(EveryKey, IsUsedByTheseTests) {
  std::set<const Key*> used;
  for (const std::string& text : GetParam().texts) {
    ASSERT_EQ(refusal_of(text), "");
    walk(keys::parse_toml(text, "").root, GetParam().declared(),
         [&](const Key& key, const keys::Entry&) { used.insert(&key); });
  }
  const std::function<void(const Key&)> expect_used = [&](const Key& table) {
    for (const Key& key : table.inner) {
      EXPECT_EQ(used.count(&key), 1U) << table.name << ": " << key.name;
      if (keys::is_table(key)) {
        expect_used(key);
      }
    }
  };
  expect_used(GetParam().declared());
}

TEST_P(EveryKey, IsRefusedWithAWrongTypeOrOutsideItsRange) {
  int outside = 0;
  for_each_value([&](const std::string& text, const Key& key, const keys::Entry& entry) {
    std::vector<std::string> wrong = out_of_range(key);
    outside += static_cast<int>(wrong.size());
    wrong.insert(wrong.end(), {"true", "11:00:02", "{}"});  // valid for no key
    if (key.type != Type::kTextOrWhole && key.type != Type::kInstant) {
      wrong.emplace_back(keys::is_number(key) ? "\"6\"" : "6");
    }
    for (const std::string& value : wrong) {
      EXPECT_THAT(refusal_of(spoilt(text, entry.value.at, value)),
                  StartsWith(place(entry.value.at) + key.name + " is "))
          << value;
    }
  });
  EXPECT_GT(outside, 2);
}

TEST_P(EveryKey, IsSuggestedIfItsNameIsMisspelt) {
  for_each_value([&](const std::string& text, const Key& key, const keys::Entry& entry) {
    EXPECT_THAT(refusal_of(spoilt(text, entry.at, key.name + "x = 1")),
                testing::AllOf(StartsWith(place(entry.at) + "unknown key"),
                               HasSubstr("did you mean \"" + key.name + "\"?")));
  });
}

TEST_P(EveryKey, IsReportedIfItIsRequiredAndMissing) {
  int required = 0;
  for_each_value([&](const std::string& text, const Key& key, const keys::Entry& entry) {
    if (!key.required) {
      return;
    }
    EXPECT_THAT(refusal_of(spoilt(text, entry.at, "")),
                HasSubstr("missing key \"" + key.name + "\" in "));
    ++required;
  });
  EXPECT_GT(required, 2);
}

TEST_P(EveryKey, IsDocumentedInTheReadme) {
  std::string readmes;
  for (const char* const name :
       {"/profiles/README.md", "/profiles/stations.md", "/drivers/README.md"}) {
    std::ifstream file(std::string(GSBENCH_SOURCE_DIR) + name);
    readmes.append(std::istreambuf_iterator<char>(file), {});
  }
  EXPECT_THAT(readmes, HasSubstr(keys::markdown(GetParam().declared())))
      << "replace the tables with the output of `gsbench schema FORMAT --markdown`";
}

const File kFiles[] = {
    {"profile",
     &profile_keys,
     {kLossesInPlace, kDisturbed, kPoints, kRecording, kForeignRecording},
     [](const std::string& path) { (void)load_profile(path); }},
    {"grid", &grid_keys, {grid_file()}, [](const std::string& path) { (void)load_grid(path); }},
    {"emulated_station",
     [] { return std::cref(station::station_keys("emulated")); },
     {kEmulatedStation, kEmulatedGenerator, kEmulatedHead},
     [](const std::string& path) { (void)station::load_station(path); }},
    {"physical_station",
     [] { return std::cref(station::station_keys("physical")); },
     {kPhysicalStation, kSlots, kHeadStation},
     [](const std::string& path) { (void)station::load_station(path); }},
    {"instrument", [] { return std::cref(station::instrument_keys()); }, instrument_texts(),
     [](const std::string& path) { (void)station::load_instrument(path); }},
};
INSTANTIATE_TEST_SUITE_P(OfA, EveryKey, testing::ValuesIn(kFiles),
                         [](const auto& file) { return std::string(file.param.name); });

}  // namespace
}  // namespace gsbench::profile::test

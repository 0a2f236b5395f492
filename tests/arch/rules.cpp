#include "rules.hpp"

#include "tree.hpp"

#include <algorithm>
#include <set>

namespace gsbench::arch {
namespace {

constexpr std::string_view kRecordData = "record/run_record.hpp";
constexpr std::string_view kPageData = "record/page.hpp";

using Names = std::set<std::string_view>;

}  // namespace

const std::vector<FolderRule>& folder_rules() {
  static const std::vector<FolderRule> rules = {
      {"firmware/outlet", {}},
      {"firmware/wire", {"firmware/outlet"}},
      {"firmware/app", {"firmware/outlet", "firmware/wire"}},
      {"firmware/queues", {}},
      {"firmware/head/stm32f405",
       {"firmware/outlet", "firmware/wire", "firmware/queues", "firmware/head",
        "firmware/boards/cortex_m4", "firmware/boards/stm32f405_chip"},
       "head_stm32f405"},
      {"firmware/head", {"firmware/outlet", "firmware/wire", "firmware/queues"}},
      {"firmware/boards/list", {}, "boards"},
      {"firmware/boards/settings_storage", {"firmware/outlet", "firmware/wire", "firmware/app"}},
      {"firmware/boards/shared_memory_io",
       {"firmware/outlet", "firmware/wire", "firmware/app", "firmware/boards/settings_storage"}},
      {"firmware/boards/superloop",
       {"firmware/outlet", "firmware/wire", "firmware/app", "firmware/boards/settings_storage"}},
      {"firmware/boards/cortex_m4", {}},
      {"firmware/boards/mps2_an386",
       {"firmware/outlet", "firmware/wire", "firmware/app", "firmware/boards/settings_storage",
        "firmware/boards/shared_memory_io", "firmware/boards/superloop",
        "firmware/boards/cortex_m4", "firmware/queues"}},
      {"firmware/boards/stm32f405_chip",
       {"firmware/outlet", "firmware/queues", "firmware/boards/cortex_m4"}},
      {"firmware/boards/stm32f405",
       {"firmware/outlet", "firmware/wire", "firmware/app", "firmware/boards/settings_storage",
        "firmware/boards/superloop", "firmware/boards/cortex_m4", "firmware/boards/stm32f405_chip",
        "firmware/queues"}},
      {"firmware/boards/host",
       {"firmware/outlet", "firmware/wire", "firmware/app", "firmware/boards/settings_storage",
        "firmware/boards/shared_memory_io", "firmware/boards/superloop"}},
      {"drivers/common", {}, "drivers"},
      {"drivers/models", {}},
      {"drivers/transport", {"drivers/common"}},
      // Subfolders of a role come before it: the first matching row counts.
      {"drivers/source/scpi",
       {"drivers/common", "drivers/source", "drivers/transport", "drivers/models"},
       "source_scpi"},
      {"drivers/source",
       {"drivers/common", "drivers/models", "firmware/wire", "drivers/link", "drivers/relay"}},
      // Subfolders of drivers/link come before it: the first matching row counts.
      {"drivers/link/framed",
       {"drivers/common", "drivers/link", "drivers/transport", "firmware/wire"},
       "link_framed"},
      {"drivers/link/mqtt",
       {"drivers/common", "drivers/link", "drivers/transport", "firmware/wire"},
       "link_mqtt"},
      {"drivers/link", {"drivers/common", "firmware/wire", "drivers/source", "drivers/relay"}},
      {"drivers/relay/modem_line",
       {"drivers/common", "drivers/relay", "drivers/source"},
       "relay_modem_line"},
      {"drivers/relay", {"drivers/common", "firmware/wire", "drivers/source", "drivers/link"}},
      {"drivers/head",
       {"drivers/common", "drivers/models", "drivers/transport", "drivers/source", "drivers/relay",
        "firmware/outlet", "firmware/queues", "firmware/wire", "firmware/head"},
       "head_driver"},
      {"drivers/simulated", {"drivers", "firmware"}},
      {"drivers/emulation", {"drivers", "firmware"}},
      {"bench/installation", {}},
      {"bench/keys", {}},
      {"bench/measures", {}},
      {"bench/grid", {}},
      {"bench/control_centre", {"bench/grid", "firmware/outlet"}},
      {"bench/campaign",
       {"drivers/common", "drivers/models", "bench/grid", "bench/control_centre",
        "firmware/outlet"}},
      {"bench/fleet",
       {"drivers/common", "drivers/models", "bench/grid", "bench/control_centre", "bench/campaign",
        "bench/waveform", "bench/profile", "firmware/outlet", kPageData}},
      {"bench/immunity",
       {"drivers/common", "drivers/models", "bench/grid", "bench/keys", "bench/control_centre",
        "bench/campaign", "bench/waveform", "bench/profile", "firmware/outlet", kPageData}},
      {"bench/recording", {}},
      {"bench/waveform", {"bench/grid", "bench/recording"}},
      {"bench/profile",
       {"bench/installation", "bench/keys", "bench/measures", "bench/grid", "bench/control_centre",
        "bench/recording", "bench/waveform", "firmware/outlet"}},
      {"bench/capture",
       {"bench/grid", "bench/waveform", "bench/profile", "drivers/common", "drivers/link",
        "firmware/wire", kRecordData}},
      {"bench/judge",
       {"bench/measures", "bench/grid", "bench/waveform", "bench/profile", "firmware/outlet",
        kRecordData}},
      {"bench/station",
       {"bench/installation", "bench/keys", "bench/measures", "bench/grid", "bench/control_centre",
        "bench/waveform", "bench/profile", "bench/capture", "bench/judge", "drivers",
        "firmware/wire", "firmware/boards/list", "reports/record"}},
      {"bench/equivalence", {"bench/grid", "bench/waveform", "bench/profile", kRecordData}},
      {"bench/seed_sweep",
       {"bench/measures", "bench/grid", "bench/waveform", "bench/profile", "bench/capture",
        "bench/station", "drivers", "firmware/wire", "reports/record"}},
      {"bench/paper",
       {"bench/grid", "bench/control_centre", "bench/campaign", "bench/fleet", "firmware/outlet",
        kPageData, kRecordData}},
      {"bench/cli", {"bench", "drivers", "firmware", "reports"}},
      {"reports/record", {}},
      {"reports/render", {"reports/record"}},
      {"tests", {"bench", "drivers", "firmware", "reports"}},
  };
  return rules;
}

const std::vector<LibraryRule>& library_rules() {
  static const std::vector<LibraryRule> rules = {
      {"Eigen", {"Eigen/"}, {"tests"}},
      {"Eigen's unsupported part", {"unsupported/Eigen/"}, {"tests"}},
      {"SQLite", {"sqlite3.h"}, {"reports/record"}},
      {"zlib", {"zlib.h"}, {"reports/record"}},
      {"toml++", {"toml++/"}, {"bench/keys"}},
      {"CLI11", {"CLI/"}, {"bench/cli"}},
      {"Random123", {"Random123/"}, {"drivers/models"}},
      {"mustache", {"kainjow/"}, {"reports/render"}},
      {"nlohmann-json", {"nlohmann/"}, {"bench/cli", "reports/render"}},
      {"fmt", {"fmt/"}, {"bench", "drivers", "reports"}},
      {"Qt", {"Q^"}, {"bench/profile", "reports"}},
      {"libserialport", {"libserialport.h"}, {"drivers/transport"}},
      {"Paho", {"MQTT", "mqtt/"}, {"drivers/link"}},
      {"OpenSSL", {"openssl/"}, {"drivers/link", "firmware/boards/host"}},
      {"libmosquitto", {"mosquitto.h", "mqtt_protocol.h"}, {"firmware/boards/host", "tests"}},
      {"ALSA", {"alsa/"}, {"drivers/source", "drivers/link", "drivers/relay"}},
      {"GoogleTest", {"gtest/", "gmock/"}, {"tests"}},
      {"Google Benchmark", {"benchmark/"}, {"tests"}},
      {"vector instructions", {"immintrin.h"}, {"drivers/models"}},
      {"POSIX",
       {"arpa/", "dirent.h", "fcntl.h", "getopt.h", "netdb.h", "netinet/", "poll.h", "pthread.h",
        "pwd.h", "signal.h", "sys/", "termios.h", "unistd.h"},
       {"bench/station", "bench/cli", "drivers", "firmware/boards/host", "reports"}},
  };
  return rules;
}

bool is_standard_header(std::string_view header) {
  return std::all_of(header.begin(), header.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; });
}

// Headers without heap, exceptions, libm, clock and locale: they need no operating system.
bool is_freestanding_header(std::string_view header) {
  static const Names headers = {
      "algorithm",        "array",  "cfloat",   "climits", "cstddef",     "cstdint", "cstring",
      "initializer_list", "limits", "optional", "tuple",   "type_traits", "utility"};
  return headers.count(header) > 0;
}

bool is_freestanding(std::string_view path) {
  return is_within(path, "firmware") && !is_within(path, "firmware/boards/host");
}

bool may_stand_at_top_level(std::string_view entry) {
  static const Names entries = {".ci",
                                ".clang-format",
                                ".clang-tidy",
                                ".gitignore",
                                "CHANGELOG.md",
                                "CMakeLists.txt",
                                "CMakePresets.json",
                                "CONTRIBUTING.md",
                                "LICENSE",
                                "README.md",
                                "bench",
                                "dev",
                                "drivers",
                                "firmware",
                                "profiles",
                                "reports",
                                "tests"};
  return entries.count(entry) > 0;
}

bool may_link(const FolderRule& from, const FolderRule& to) {
  return from.folder == to.folder ||
         std::any_of(from.may_include.begin(), from.may_include.end(), [&](std::string_view what) {
           return is_within(to.folder, what) || owner_of_header(what) == &to;
         });
}

bool is_within(std::string_view path, std::string_view folder) {
  return path == folder ||
         (starts_with(path, folder) && path.size() > folder.size() && path[folder.size()] == '/');
}

bool is_within_any(std::string_view path, const std::vector<std::string_view>& folders) {
  return std::any_of(folders.begin(), folders.end(),
                     [&](std::string_view folder) { return is_within(path, folder); });
}

const FolderRule* rule_of(std::string_view path) {
  for (const FolderRule& rule : folder_rules()) {
    if (is_within(path, rule.folder)) {
      return &rule;
    }
  }
  return nullptr;
}

const FolderRule* owner_of_header(std::string_view header) {
  const auto slash = header.find('/');
  if (slash == std::string_view::npos) {
    return nullptr;
  }
  for (const FolderRule& rule : folder_rules()) {
    if (rule.include_root == header.substr(0, slash)) {
      return &rule;
    }
  }
  return nullptr;
}

}  // namespace gsbench::arch

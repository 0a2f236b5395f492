// Recordings of a collapse in a grid analyser's format: a row every 2 s with date and time of day,
// phase voltages in volts, gaps as NaN, and a frequency that continues on the dead bus. One
// recording is generated here. If $GSBENCH_RECORDINGS names a folder with the recording of Toledo,
// 28 April 2025, that is used too.
#pragma once

#include <test_support/temporary_folder.hpp>

#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace gsbench::test {

struct CollapseRecording {
  std::string path;
  double last_ordinary_s;  // 49.942 Hz; 4 s later 48.556, 6 s later 47.476, 8 s later dead
  std::size_t points;      // rows without gaps
};

inline constexpr const char* kCollapseTime = "time";
inline constexpr const char* kCollapseFrequency = "AnalyzerL1Frequency";
inline constexpr const char* kCollapseVoltage = "AnalyzerL1PhaseVoltage";

inline CollapseRecording make_collapse(const TemporaryFolder& folder) {
  constexpr int kRows = 150;
  constexpr int kLastOrdinary = 100;
  constexpr int kGap = 45;
  std::string text = fmt::format("{},AnalyzerL2PhaseVoltage,AnalyzerL3PhaseVoltage,{},{}\n",
                                 kCollapseVoltage, kCollapseFrequency, kCollapseTime);
  for (int row = 0; row < kRows; ++row) {
    const int after = row - kLastOrdinary;
    const double hz = after == 0   ? 49.942
                      : after == 1 ? 49.902
                      : after == 2 ? 48.556
                      : after == 3 ? 47.476
                      : after > 3  ? 47.7 - 0.07 * after
                                   : 49.98 + 0.001 * (row % 30);
    const double volts = after > 3 ? 31.9 : after == 3 ? 25872.7 : 27000.0 + 10.0 * (row % 9);
    const std::string values =
        row == kGap ? "NaN,NaN,NaN,NaN" : fmt::format("{0:.3f},{0:.3f},{0:.3f},{1:.3f}", volts, hz);
    text += fmt::format("{},28-Apr-2025 11:{:02}:{:02}\n", values, row / 30, row % 30 * 2);
  }
  return {folder.write("collapse.csv", text), 2.0 * kLastOrdinary, kRows - 1};
}

inline std::vector<CollapseRecording> collapse_recordings(const TemporaryFolder& folder) {
  std::vector<CollapseRecording> all = {make_collapse(folder)};
  if (const char* recordings = std::getenv("GSBENCH_RECORDINGS")) {
    // From 11:00:00 to 12:33:16; 3600 rows, ten of which are gaps.
    all.push_back({std::string(recordings) + "/iberia-2025-04-28-toledo.csv", 5596.0, 3590});
  }
  return all;
}

}  // namespace gsbench::test

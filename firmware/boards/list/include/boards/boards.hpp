// The list of boards, one per line. The list determines three things:
// - which folders and images are built (boards/CMakeLists.txt reads this file),
// - which images are tested,
// - which boards the station file of an emulated station may name.
#pragma once

#include <cstring>

namespace gs::boards {

struct Board {
  const char* folder;   // its image is gs-outlet-<folder>.elf
  const char* core;     // "cortex_m4": image of the cross build; "process": the program gs-outlet
  const char* name;     // in the hello and in station files
  const char* machine;  // for qemu-system-arm; `psram` is the shared memory; empty: no qemu
  bool has_radio;       // supports MQTT besides the serial line
};

inline constexpr Board kBoards[] = {
    {"mps2_an386", "cortex_m4", "mps2-an386", "mps2-an386,memory-backend=psram", false},
    {"stm32f405", "cortex_m4", "stm32f405", "", false},
    {"host", "process", "host", "", true},
};

inline bool is_process(const Board& board) {
  return std::strcmp(board.core, "process") == 0;
}

// True if an emulated station can start the board.
inline bool is_emulated(const Board& board) {
  return is_process(board) || board.machine[0] != '\0';
}

// Returns nullptr for an unknown name.
inline const Board* find(const char* name) {
  for (const Board& board : kBoards) {
    if (std::strcmp(board.name, name) == 0) {
      return &board;
    }
  }
  return nullptr;
}

}  // namespace gs::boards

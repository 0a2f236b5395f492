// The boards, a line each: from it come the folders and images that are built (CMakeLists.txt above
// reads it), the image's tests, and the boards that an emulated station may name.
#pragma once

#include <cstring>

namespace gs::boards {

struct Board {
  const char* folder;   // its image is gs-outlet-<folder>.elf
  const char* core;     // "cortex_m4": images by the cross build; "process": a program, gs-outlet
  const char* name;     // in its firmware's hello and in station files
  const char* machine;  // of qemu-system-arm, with its memory `psram` shared; empty: none has it
  bool has_radio;       // reached over MQTT too, not by serial line alone
};

inline constexpr Board kBoards[] = {
    {"mps2_an386", "cortex_m4", "mps2-an386", "mps2-an386,memory-backend=psram", false},
    {"stm32f405", "cortex_m4", "stm32f405", "", false},
    {"host", "process", "host", "", true},
};

inline bool is_process(const Board& board) {
  return std::strcmp(board.core, "process") == 0;
}

// An emulated station can start it.
inline bool is_emulated(const Board& board) {
  return is_process(board) || board.machine[0] != '\0';
}

// nullptr where no board has that name.
inline const Board* find(const char* name) {
  for (const Board& board : kBoards) {
    if (std::strcmp(board.name, name) == 0) {
      return &board;
    }
  }
  return nullptr;
}

}  // namespace gs::boards

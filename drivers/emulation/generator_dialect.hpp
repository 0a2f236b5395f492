// How a maker's instruments read messages and answer.
#pragma once

#include "generator_state.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

namespace gsbench::emulation {

struct GeneratorReply {
  std::string bytes;  // with their newline; empty: no answer
  // The answer is sent, and the next message read, at this step. max(): never.
  std::int64_t not_before = std::numeric_limits<std::int64_t>::min();
};

class GeneratorDialect {
 public:
  virtual ~GeneratorDialect() = default;
  // The size of the first message in `bytes`, with its newline; 0: not complete.
  virtual std::size_t message_size(std::string_view bytes) = 0;
  // Whether the last message looked at ends within a block whose length is known.
  virtual bool in_block() const { return false; }
  // The rest of a block did not come.
  virtual void give_up_block() {}
  // When the bytes arrived of the messages that are executed next.
  virtual void arrived(std::int64_t /*step*/) {}
  // `message`: with its newline.
  virtual GeneratorReply execute(std::string_view message) = 0;
  // What of a message is text: its size without newline and block.
  virtual std::size_t text_size(std::string_view message) const = 0;
  virtual void connect() {}     // a new client: what is left of a message is forgotten
  virtual void lose_power() {}  // the state is reset by its owner
  virtual void fill_errors() {}
};

std::unique_ptr<GeneratorDialect> make_siglent(GeneratorState& state, bool sample_rates);
std::unique_ptr<GeneratorDialect> make_rigol(GeneratorState& state);
std::unique_ptr<GeneratorDialect> make_keysight(GeneratorState& state);

}  // namespace gsbench::emulation

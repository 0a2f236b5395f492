// Messages to one instrument and its answers: lines, and blocks of bytes. One command at a time,
// with the pauses that the instrument needs. Errors name the port, the message and the reason. All
// functions return an error if interrupted.
#pragma once

#include <source_scpi/instrument.hpp>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <source/interrupt.hpp>
#include <transport/transport.hpp>

namespace gsbench::scpi {

class Connection {
 public:
  // `instrument` and `interrupt` must outlive the connection.
  Connection(const Instrument& instrument, const std::string& port, int baud,
             source::Interrupt& interrupt);

  // Opens the port and asks for the instrument's identity. After an error the port is closed, but
  // see speaks_to_another() and open_mute().
  drivers::Status open();
  // Opens the port without asking anything.
  drivers::Status open_mute() { return transport_->open(); }
  void close() noexcept;
  bool is_open() const { return transport_->is_open(); }
  // The last open() failed because an instrument of another model answered.
  bool speaks_to_another() const { return speaks_to_another_; }
  const std::string& identification() const { return identification_; }

  drivers::Status send(const std::string& command);
  // The same without the pause afterwards.
  drivers::Status send_at_once(const std::string& command);
  // One message: header, bytes, newline. `sent`: called with the number of bytes sent so far. The
  // port is closed if interrupted within the bytes.
  drivers::Status send_block(const std::string& header, const std::vector<std::uint8_t>& bytes,
                             const std::function<void(std::size_t)>& sent);
  drivers::Status pause(double time_s);
  // Returns the line without its end. After an error by time-out the connection stays usable: what
  // arrives late is discarded before the next query.
  drivers::Result<std::string> ask(const std::string& query);
  // The same in two parts that do not wait for the answer: begin_query() sends, poll_answer()
  // returns the line once it has arrived. Other queries end this one.
  drivers::Status begin_query(const std::string& query);
  bool has_query() const { return begun_.has_value(); }
  drivers::Result<std::optional<std::string>> poll_answer();
  // The bytes after "WAVEDATA," in an answer that states their number as LENGTH,<n>B.
  drivers::Result<std::vector<std::uint8_t>> ask_waveform(const std::string& query);

 private:
  drivers::Status discard_answers_to_others();
  drivers::Status prepare_query(const std::string& query);
  drivers::Status synchronise();
  drivers::Status write(const std::vector<std::uint8_t>& bytes);
  // Appends at least one byte to received_; an error after the time-out, or if the port is gone.
  drivers::Status receive(const std::string& query, transport::Clock::time_point until);
  std::optional<std::string> take_line();
  drivers::Result<std::string> line(const std::string& query, transport::Clock::time_point until);
  drivers::Error interrupted(const std::string& doing) const;
  drivers::Error no_answer(const std::string& query);
  // Later by what the instrument may still need to take the waveforms that were sent.
  transport::Clock::time_point answer_deadline() const;

  // A query that waits for its answer.
  struct Begun {
    std::string query;
    transport::Clock::time_point until;
  };

  const Instrument& instrument_;
  source::Interrupt& interrupt_;
  std::unique_ptr<transport::Transport> transport_;
  std::vector<std::uint8_t> received_;
  std::optional<Begun> begun_;
  double upload_bytes_s_;  // slowest rate of the instrument, or of the serial port
  transport::Clock::time_point takes_until_;  // what was sent, at that rate
  bool late_answers_ = false;                 // after a time-out
  bool speaks_to_another_ = false;
  std::string identification_;
};

}  // namespace gsbench::scpi

// Carries a host outlet's frames: a line over TCP, or a broker.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include <app/endpoint.hpp>

namespace gs::host {

class Line : public app::Carrier {
 public:
  virtual ~Line() = default;
  // Takes the next received byte. Returns false if there is none.
  bool take_byte(std::uint8_t& byte) {
    if (received_.empty()) {
      return false;
    }
    byte = received_.front();
    received_.pop_front();
    return true;
  }
  // Receives bytes and sends queued bytes. Does not block.
  virtual void serve() = 0;
  virtual int descriptor() const = 0;  // -1: no socket now
  virtual bool wants_to_write() const = 0;
  // A thread of the line tries to connect. The destructor waits for it.
  virtual bool is_connecting() const { return false; }
  // True once after a reconnection: the outlet must then send its hello again.
  virtual bool take_reconnected() { return false; }
  // What people should know, since the last call: connections that begin or end.
  std::vector<std::string> take_news() { return std::exchange(news_, {}); }
  // Messages lost since the last call although send() had accepted them.
  virtual std::uint32_t take_unsent() { return 0; }

 protected:
  void report(std::string news) { news_.push_back(std::move(news)); }

  std::deque<std::uint8_t> received_;  // bytes of frames, added by serve()

 private:
  std::vector<std::string> news_;
};

}  // namespace gs::host

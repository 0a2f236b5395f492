// Emulated outlets at nominal voltage and frequency for the duration of a test, on serial lines or
// behind a broker.
#pragma once

#include "gsbench_process.hpp"
#include <test_support/demand.hpp>
#include <test_support/mains.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <atomic>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <emulation/hardware.hpp>
#include <station/station_lock.hpp>

namespace gsbench::test {

using emulation::Connection;

class LiveOutlets : public testing::Test {
 protected:
  explicit LiveOutlets(Connection connection, std::vector<std::string> ids = {"kitchen-1"})
      : connection_(connection), ids_(std::move(ids)) {}
  void SetUp() override {
    emulation::HardwareOptions options;
    for (const std::string& id : ids_) {
      options.outlets.push_back({id, "host", connection_, 0.0});
    }
    options.host_program = GS_OUTLET_PROGRAM;
    hardware_ = demand(emulation::Hardware::set_up(options));
    mains_ = std::thread([this] { play(); });
    if (connection_ == Connection::kSerial) {
      where_ = hardware_->serial_ports().front();
      return;
    }
    const auto& broker = *hardware_->broker();
    where_ = broker.url();
    folder_.write("bench.password", broker.bench().password + "\n");
    station_ = folder_.write("station.toml",
                             "title = \"Radio\"\nkind = \"physical\"\n[mqtt]\nurl = \"" + where_ +
                                 "\"\nca_file = \"" + broker.ca_file() + "\"\nuser = \"" +
                                 broker.bench().user + "\"\npassword_file = \"bench.password\"\n");
  }
  void TearDown() override {
    over_ = true;
    if (mains_.joinable()) {
      mains_.join();
    }
    for (const std::string& port : hardware_->serial_ports()) {
      std::filesystem::remove(station::lock_files(port).front());
    }
  }

  // The command with the options that reach the outlets.
  Words to_it(const std::string& command, const Words& more = {}) const {
    Words words = {command};
    if (connection_ == Connection::kMqtt) {
      words.insert(words.end(), {"--station", station_});
    } else {
      for (const std::string& port : hardware_->serial_ports()) {
        words.insert(words.end(), {"--port", port});
      }
    }
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  const Connection connection_;
  const std::vector<std::string> ids_;
  const TemporaryFolder folder_;
  std::unique_ptr<emulation::Hardware> hardware_;
  std::string where_;  // the first port, or the broker's URL
  std::string station_;

 private:
  void play() try {
    Mains mains;
    mains.duration_s = 600.0;
    start(hardware_->source(), mains);
    for (std::int64_t tick = 128; !over_; tick += 128) {
      advance(hardware_->source(), tick);
    }
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what();
  }

  std::atomic<bool> over_{false};
  std::thread mains_;
};

inline bool shows(const Started& started, const std::string& text) {
  return until([&] { return text_of(started.out).find(text) != std::string::npos; });
}
inline bool says(const Started& started, const std::string& text) {
  return until([&] { return text_of(started.err).find(text) != std::string::npos; });
}

inline Words lines_of(const std::string& text) {
  std::istringstream stream(text);
  Words lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

}  // namespace gsbench::test

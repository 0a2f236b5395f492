// Outlets' processes on serial cables, each on mains of its own, a link to them, and all that came
// over it.
#pragma once

#include <link_serial/serial_link.hpp>
#include <link_test/hears_a_link.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <emulation/child.hpp>
#include <emulation/mains.hpp>
#include <emulation/null_modem.hpp>

namespace gsbench::test {

class OutletsOnCables : public HearsALink {
 protected:
  struct Outlet {
    std::string id;
    std::string folder;
    std::unique_ptr<emulation::Mains> mains;
    std::unique_ptr<emulation::NullModem> cable;
    std::unique_ptr<emulation::Child> process;
    std::int64_t tick = 0;

    // As udev names ports: the same however often the cable is unplugged.
    std::string bench_port() const { return folder + "/bench-port"; }
    std::string outlet_port() const { return folder + "/outlet-port"; }
  };

  void TearDown() override {
    HearsALink::TearDown();
    for (Outlet& outlet : outlets_) {
      if (outlet.process) {
        ::kill(outlet.process->pid(), SIGCONT);
      }
    }
  }

  // Nobody on it.
  std::size_t lay_cable(const std::string& id) {
    Outlet outlet;
    outlet.id = id;
    outlet.folder = folder_.file(std::to_string(outlets_.size()));
    std::filesystem::create_directory(outlet.folder);
    outlets_.push_back(std::move(outlet));
    plug_in(outlets_.size() - 1);
    return outlets_.size() - 1;
  }

  std::size_t add(const std::string& id) {
    const std::size_t place = lay_cable(id);
    Outlet& outlet = outlets_[place];
    emulation::MainsOptions options;
    options.folder = outlet.folder;
    options.outlets = {{id, 0.0}};
    options.real_time = false;
    auto mains = emulation::Mains::create(options);
    EXPECT_TRUE(mains.ok()) << mains.error();
    outlet.mains = mains.take();
    source::SourceSettings settings;
    settings.sample_rate_hz = options.sample_rate_hz;
    settings.nominal_hz = options.nominal_hz;
    EXPECT_TRUE(outlet.mains->source().start(settings).ok());
    start(place);
    return place;
  }

  void start(std::size_t place) {
    Outlet& outlet = outlets_[place];
    auto child = emulation::Child::start(
        {{GS_OUTLET_PROGRAM, "--serial", outlet.outlet_port(), "--terminals",
          outlet.mains->terminal_path(0), "--doorbell", outlet.mains->doorbell_path(0)},
         ""});
    ASSERT_TRUE(child.ok()) << child.error();
    outlet.process = std::make_unique<emulation::Child>(child.take());
  }

  void plug_in(std::size_t place) {
    Outlet& outlet = outlets_[place];
    auto cable = emulation::NullModem::between_terminals();
    ASSERT_TRUE(cable.ok()) << cable.error();
    outlet.cable = std::make_unique<emulation::NullModem>(cable.take());
    point(outlet.bench_port(), outlet.cable->bench_end());
    point(outlet.outlet_port(), outlet.cable->outlet_end());
  }

  void unplug(std::size_t place) {
    Outlet& outlet = outlets_[place];
    outlet.cable.reset();
    std::filesystem::remove(outlet.bench_port());
    std::filesystem::remove(outlet.outlet_port());
  }

  // Of an outlet that has said hello: so many measurements, of 16 ms each.
  void play(std::size_t place, int reports) {
    // The converter keeps the last two ticks until the next come.
    if (outlets_[place].tick == 0) {
      play_ticks(place, 8);
    }
    for (int i = 0; i < reports; ++i) {
      play_ticks(place, 128);
    }
  }

  link::SerialOptions options() const {
    link::SerialOptions options;
    for (const Outlet& outlet : outlets_) {
      options.ports.push_back(outlet.bench_port());
    }
    return options;
  }

  void open() {
    link_ = std::make_unique<link::SerialLink>(options());
    auto opened = link_->open();
    ASSERT_TRUE(opened.ok()) << opened.error();
    present_ = opened.take();
  }

  // The error of an opening that fails.
  static std::string refusal(const link::SerialOptions& options) {
    link::SerialLink link(options);
    const auto opened = link.open();
    return opened.ok() ? "it opened" : opened.error();
  }

  void send(std::size_t outlet, const gs::wire::Downlink& message) {
    const auto sent = link_->send(outlet, message);
    ASSERT_TRUE(sent.ok()) << sent.error();
  }

  static gs::wire::Downlink ping(std::uint32_t token) {
    gs::wire::Downlink message;
    message.kind = gs::wire::DownlinkKind::kPing;
    message.token = token;
    return message;
  }

  bool answers(std::size_t outlet, std::uint32_t token) {
    send(outlet, ping(token));
    return until([&] {
      const auto echoes = messages(outlet, gs::wire::UplinkKind::kEcho);
      return std::any_of(echoes.begin(), echoes.end(), [&](const link::Received& received) {
        return received.message.echo.token == token;
      });
    });
  }

  TemporaryFolder folder_;
  std::vector<Outlet> outlets_;
  std::vector<link::OutletPresence> present_;

 private:
  void play_ticks(std::size_t place, std::size_t count) {
    Outlet& outlet = outlets_[place];
    const std::vector<float> block(count);
    const auto played = outlet.mains->source().play(outlet.tick, block.data(), count);
    ASSERT_TRUE(played.ok()) << played.error();
    outlet.tick += static_cast<std::int64_t>(count);
  }

  static void point(const std::string& link, const std::string& device) {
    std::error_code error;
    std::filesystem::create_symlink(device, link, error);
    ASSERT_FALSE(error) << error.message();
  }
};

}  // namespace gsbench::test

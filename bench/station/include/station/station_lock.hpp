// One bench at a time uses a station: `run`, `devices` and `monitor` lock the ports that they open.
// For each port there is a lock file, which the bench locks with flock(2): the kernel releases it
// when the bench ends, also by SIGKILL. The files are in /tmp, because /run/lock may be missing, or
// for root only. They are never removed: a new file of the same name would be a second lock.
//
// A port is locked as what its name leads to: a device through symbolic links, a TCP port at each
// address of its host. An outlet behind a broker is a port, too: "mqtts://host:8883/kitchen-2". Its
// lock counts for all ports of the broker's host, with and without TLS.
//
// The lock is known on this machine only. Two machines can still use one instrument over TCP, or
// one outlet behind a broker.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <drivers/descriptor.hpp>

namespace gsbench::station {

// what() names the port and who uses it.
class StationBusy : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class StationLock {
 public:
  // Locks all ports. `doing`: for the message to others, "profile x" or "command monitor". Empty
  // ports, and a port that is listed twice, count once. Blocks for the look-up of host names.
  // Throws StationBusy, and std::runtime_error if a lock file cannot be used.
  StationLock(const std::vector<std::string>& ports, const std::string& doing);
  ~StationLock();
  StationLock(const StationLock&) = delete;
  StationLock& operator=(const StationLock&) = delete;

 private:
  void take(const std::string& path, const std::string& port, const std::string& doing);

  std::vector<drivers::Descriptor> files_;
};

// Who uses this port: "user anna, process 4711 (gsbench), profile x, since …". Empty: nobody.
// Blocks for the look-up of a host name.
std::string lock_holder(const std::string& port);

// The device that a path leads to, through symbolic links; other ports as they are.
std::string device_of(const std::string& port);

// The lock files of a port: one for a device, one for each address of a host. Two names of one port
// share a file. Blocks for the look-up of a host name.
std::vector<std::string> lock_files(const std::string& port);

}  // namespace gsbench::station

// One bench at a time uses a station: `run`, `devices` and `monitor` lock the ports that they open.
// For each port there is a lock file, which the bench locks with flock(2): the kernel releases it
// when the bench ends, also by SIGKILL. The files are in /tmp, because /run/lock may be missing, or
// for root only. They are never removed: a new file of the same name would be a second lock.
//
// The lock is known on this machine only. Two machines can still use one instrument over TCP.
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
  // ports, and a port that is listed twice, count once. Throws StationBusy, and std::runtime_error
  // if a lock file cannot be used.
  StationLock(const std::vector<std::string>& ports, const std::string& doing);
  ~StationLock();
  StationLock(const StationLock&) = delete;
  StationLock& operator=(const StationLock&) = delete;

 private:
  std::vector<drivers::Descriptor> files_;
};

// Who uses this port: "user anna, process 4711 (gsbench), profile x, since …". Empty: nobody.
std::string lock_holder(const std::string& port);

// The device that a path leads to, through symbolic links; other ports as they are.
std::string device_of(const std::string& port);

// The lock file of a port. Two names of one device have the same file.
std::string lock_file(const std::string& port);

}  // namespace gsbench::station

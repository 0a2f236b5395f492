// A few threads that share out numbered pieces of work; which thread does which piece changes
// nothing in the result.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace gsbench::drivers {

class Workers {
 public:
  // At least 1; the caller's thread is one of them. Fewer where the system gives no more.
  explicit Workers(std::size_t threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  // Calls work(0) … work(pieces − 1), each once, and returns when all are done; then throws the
  // first exception that came out of any.
  void run(std::size_t pieces, const std::function<void(std::size_t)>& work);

 private:
  void serve();
  void take_pieces(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable done_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::size_t pieces_ = 0;
  std::size_t next_ = 0;
  std::size_t unfinished_ = 0;
  std::exception_ptr failure_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace gsbench::drivers

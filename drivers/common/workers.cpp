#include <algorithm>
#include <utility>

#include <drivers/workers.hpp>

namespace gsbench::drivers {

Workers::Workers(std::size_t threads) {
  const std::size_t helpers = std::max<std::size_t>(threads, 1) - 1;
  threads_.reserve(helpers);
  try {
    while (threads_.size() < helpers) {
      threads_.emplace_back([this] { serve(); });
    }
  } catch (const std::exception&) {
    // The system refuses more threads: those that have started do all the work.
  }
}

Workers::~Workers() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ending_ = true;
  }
  wake_.notify_all();
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

void Workers::run(std::size_t pieces, const std::function<void(std::size_t)>& work) {
  std::unique_lock<std::mutex> lock(mutex_);
  work_ = &work;
  pieces_ = pieces;
  next_ = 0;
  unfinished_ = pieces;
  wake_.notify_all();
  take_pieces(lock);
  done_.wait(lock, [this] { return unfinished_ == 0; });
  work_ = nullptr;
  if (failure_ != nullptr) {
    std::rethrow_exception(std::exchange(failure_, nullptr));
  }
}

void Workers::serve() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (!ending_) {
    wake_.wait(lock, [this] { return ending_ || next_ < pieces_; });
    take_pieces(lock);
  }
}

void Workers::take_pieces(std::unique_lock<std::mutex>& lock) {
  while (!ending_ && next_ < pieces_) {
    const std::size_t piece = next_++;
    const std::function<void(std::size_t)>& work = *work_;
    lock.unlock();
    std::exception_ptr thrown;
    try {
      work(piece);
    } catch (...) {
      thrown = std::current_exception();
    }
    lock.lock();
    failure_ = failure_ == nullptr ? thrown : failure_;
    if (--unfinished_ == 0) {
      done_.notify_all();
    }
  }
}

}  // namespace gsbench::drivers

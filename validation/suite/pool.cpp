#include "validation/suite/pool.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace sandglass {

namespace {
class Pool {
 public:
  explicit Pool(const std::vector<std::function<void()>>& jobs) : jobs_(jobs) {}

  void work() {
    for (std::size_t i = next_++; i < jobs_.size(); i = next_++) {
      try {
        jobs_[i]();
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        next_ = jobs_.size();
      }
    }
  }
  void rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  const std::vector<std::function<void()>>& jobs_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
};
}  // namespace

void run_in_parallel(unsigned threads, const std::vector<std::function<void()>>& jobs) {
  Pool pool(jobs);
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < std::max(1U, threads); ++i) workers.emplace_back([&pool] { pool.work(); });
  workers.clear();  // joins
  pool.rethrow();
}

}  // namespace sandglass

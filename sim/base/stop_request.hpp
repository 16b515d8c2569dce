#pragma once

#include <atomic>
#include <chrono>
#include <stdexcept>

namespace sandglass {

/// A step that would not end was given up, since the program was asked to stop.
class StoppedWithinStep : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether the program is to end. Runs look at it between two steps, where they can write a checkpoint; what may take long
/// within a step heeds it every few milliseconds.
class StopRequest {
 public:
  /// May be called by a signal handler.
  void ask();
  void withdraw() { asked_ = false; }
  const std::atomic<bool>& asked() const { return asked_; }
  /// Throws StoppedWithinStep when the step has had its time to end since it was asked.
  void heed() const {
    if (asked_.load(std::memory_order_relaxed)) [[unlikely]]
      end_overdue_step();
  }

 private:
  void end_overdue_step() const;

  std::atomic<std::chrono::steady_clock::rep> since_{0};
  std::atomic<bool> asked_{false};
};

/// Of this process.
inline StopRequest stop_request;

}  // namespace sandglass

#pragma once

#include "sim/base/stop_request.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <random>
#include <string>
#include <thread>

#include <gtest/gtest.h>

// For the fuzz tests: how many trials, from which seeds, and for how long one may run. ci/fuzz sets the environment.

namespace sandglass {

/// A trial from a seed of its own, by which it can be had again: SANDGLASS_FUZZ_SEED=<seed> with SANDGLASS_FUZZ_SECONDS=0.
class Trials {
 public:
  /// So many trials, always the same; with SANDGLASS_FUZZ_SECONDS as many as fit into that, from a seed of the day.
  explicit Trials(unsigned count) : left_(count) {
    const char *seconds = std::getenv("SANDGLASS_FUZZ_SECONDS"), *seed = std::getenv("SANDGLASS_FUZZ_SEED");
    if (seconds == nullptr) return;
    timed_ = true;
    end_ = Clock::now() +
           std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(std::atof(seconds)));
    seed_ = seed == nullptr ? std::random_device()() : static_cast<unsigned>(std::strtoul(seed, nullptr, 10));
  }

  /// Whether there is another trial; at least one.
  bool next() {
    if (done_ > 0 && testing::Test::HasFailure()) {
      std::printf("trial of seed %u\n", seed_);
      return false;
    }
    if (done_ > 0 && (timed_ ? Clock::now() > end_ : done_ >= left_)) return false;
    seed_ += done_++ > 0 ? 1 : 0;
    name_crashes(seed_);
    return true;
  }
  unsigned seed() const { return seed_; }
  unsigned done() const { return done_; }
  bool timed() const { return timed_; }

 private:
  using Clock = std::chrono::steady_clock;

  /// A crash ends the process: it must say which trial it was. Sanitizers have handlers of their own, and keep them.
  static void name_crashes(unsigned seed) {
    under_way = seed;
    for (const int signal : {SIGSEGV, SIGFPE, SIGABRT}) {
      struct sigaction known {};
      sigaction(signal, nullptr, &known);
      if (known.sa_handler == SIG_DFL) std::signal(signal, name_trial);
    }
  }
  static void name_trial(int signal) {
    std::signal(signal, SIG_DFL);
    std::fprintf(stderr, "crash in the trial of seed %u\n", under_way.load());
    std::raise(signal);
  }
  static inline std::atomic<unsigned> under_way{0};

  unsigned left_, seed_ = 20240607, done_ = 0;
  bool timed_ = false;
  Clock::time_point end_;
};

/// Asks what runs while it lives to stop when its time is up.
class Deadline {
 public:
  explicit Deadline(double seconds) : watcher_([this, seconds] { wait(seconds); }) {}
  ~Deadline() {
    {
      const std::lock_guard lock(mutex_);
      over_ = true;
    }
    changed_.notify_one();
    watcher_.join();
    stop_request.withdraw();
  }
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

 private:
  void wait(double seconds) {
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return over_; }))
      stop_request.ask();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false;
  std::thread watcher_;
};

/// A number that nobody expects, or one close to what is there.
inline double hostile_number(std::mt19937& engine, double known = 1) {
  const double strange[] = {std::nan(""),
                            HUGE_VAL,
                            -HUGE_VAL,
                            1e308,
                            -1e308,
                            1e-320,
                            -1e9,
                            0x1p40,
                            0x1p53 + 2,
                            0x1p31,
                            0x1p32,
                            -1,
                            0,
                            0.5,
                            known + 1,
                            known - 1,
                            -known,
                            2 * known,
                            known * (1 + 1e-12),
                            1e100,
                            1e-300,
                            known + 1e-9,
                            255,
                            65535};
  return strange[engine() % std::size(strange)];
}

}  // namespace sandglass

#pragma once

#include "validation/suite/outcome.hpp"
#include "validation/suite/suite.hpp"

#include <functional>
#include <mutex>
#include <string>

namespace sandglass {

/// Runs a task, writes its record when `record_path` (relative to the report folder) is not empty, judges it,
/// and repeats it once when fresh seeds are asked for and luck may be to blame.
Outcome run_task(const Task& task, const SuiteOptions& options, const std::string& record_path);

/// Counts finished work and reports it to the caller, one call at a time.
class ProgressCounter {
 public:
  ProgressCounter(const SuiteOptions& options, std::size_t runs, double work)
      : report_(options.progress), runs_(runs), work_(work) {}
  void finished(const std::string& name, double work, double cpu_seconds);

 private:
  std::function<void(const SuiteProgress&)> report_;
  std::size_t runs_, done_ = 0;
  double work_, work_done_ = 0;
  std::mutex mutex_;
};

/// Particle-moves that a scene will cost; 1 when that is not known.
double expected_work(const Scene& scene);

}  // namespace sandglass

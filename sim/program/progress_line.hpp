#pragma once

#include "sim/run/run.hpp"

#include <functional>

namespace sandglass::program {

/// One line on a terminal that follows the run with rate and time left. Does nothing where standard error is not a
/// terminal, under mpirun (whose pipes look like terminals) or with `quiet`.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine();
  std::function<void(const Progress&)> callback();

 private:
  void show(const Progress& progress);
  bool live_;
  bool shown_ = false;
};

}  // namespace sandglass::program

#pragma once

#include "sim/program/launcher.hpp"

namespace sandglass::program {

/// MPI for the lifetime of a command. It is started only where a launcher shows in the environment: to start it costs
/// tenths of a second, more than a short run, and fails where a machine forbids it.
class Parallel {
 public:
  Parallel();
  ~Parallel();
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;

  /// Whether the command may go on: no method is decomposed yet, so that more than one rank is refused. Rank 0 says so.
  bool is_alone() const { return ranks_.count == 1; }

 private:
  void refuse() const;

  bool started_ = false;
  Ranks ranks_, mpi_;
};

}  // namespace sandglass::program

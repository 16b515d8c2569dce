#pragma once

namespace sandglass::program {

/// MPI for the lifetime of a command, when the program was started by mpirun; nothing otherwise (starting MPI alone would
/// cost more than a short run). Throws InputError on more than one rank: no method is decomposed yet.
class Parallel {
 public:
  Parallel();
  ~Parallel();
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;

 private:
  bool started_ = false;
};

}  // namespace sandglass::program

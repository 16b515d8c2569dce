#pragma once

#include "sim/program/failure.hpp"
#include "sim/program/launcher.hpp"

#include <memory>
#include <string>

namespace sandglass::program {

class MpiCommunicator;

/// MPI for the lifetime of a command. It is started only where a launcher shows in the environment: to start it costs
/// tenths of a second, more than a short run, and fails where a machine forbids it.
class Parallel {
 public:
  Parallel();
  ~Parallel();
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;

  /// Null: this process is alone.
  Communicator* ranks() const;
  /// Throws Failure for more ranks than one where a command has no work to share, or where MPI does not know of them.
  void require_work(const std::string& command) const;
  /// Prints the failure once, whichever ranks have it; ends all ranks where one alone knows of it.
  int report(const Failure& failure) const;

 private:
  bool started_ = false;
  Ranks ranks_, mpi_;
  std::unique_ptr<MpiCommunicator> communicator_;
};

}  // namespace sandglass::program

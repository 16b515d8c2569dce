#include "sim/program/parallel.hpp"

#include "sim/program/mpi_communicator.hpp"
#include "sim/program/options.hpp"

#include <chrono>
#include <cstdio>
#include <thread>

#include <fmt/format.h>
#include <mpi.h>

namespace sandglass::program {

namespace {
void wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }
}  // namespace

Parallel::Parallel() {
  const Launch launch = launch_of_this_program();
  started_ = launch.starts_mpi;
  if (started_) {
    MPI_Init(nullptr, nullptr);
    MPI_Comm_size(MPI_COMM_WORLD, &mpi_.count);
    MPI_Comm_rank(MPI_COMM_WORLD, &mpi_.own);
  }
  ranks_ = ranks_of(launch, mpi_);
  if (mpi_.count > 1) communicator_ = std::make_unique<MpiCommunicator>();
}

Parallel::~Parallel() {
  if (started_) MPI_Finalize();
}

Communicator* Parallel::ranks() const { return communicator_.get(); }

/// A launcher ends all copies as soon as one has failed. Copies that MPI does not know of each other cannot ask whether
/// the first has spoken, and give it a second.
void Parallel::require_work(const std::string& command) const {
  if (ranks_.count == 1) return;
  const bool first = ranks_.own == 0;
  if (mpi_.count == 1) {
    if (!first) wait(1);
    throw Failure{
        first ? fmt::format("error: started on {} ranks by a launcher that MPI knows nothing of; use the "
                            "mpirun of the MPI that this program was built with, or one rank",
                            ranks_.count)
              : "",
        bad_input, true};
  }
  if (command != "run" && command != "resume")
    throw Failure{
        first ? fmt::format("error: started on {} ranks, but '{}' has no work to share; start it on one",
                            ranks_.count, command)
              : "",
        bad_input, true};
}

/// Others may fail of the same: each waits for those before it.
int Parallel::report(const Failure& failure) const {
  const bool ends_all = communicator_ != nullptr && !failure.everywhere;
  if (ends_all && mpi_.own > 0) wait(1 + 0.05 * mpi_.own);
  if (!failure.words.empty()) std::fprintf(stderr, "%s\n", failure.words.c_str());
  if (ends_all) {
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, failure.code);
  }
  return failure.code;
}

}  // namespace sandglass::program

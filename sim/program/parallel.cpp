#include "sim/program/parallel.hpp"

#include <chrono>
#include <cstdio>
#include <thread>

#include <mpi.h>

namespace sandglass::program {

Parallel::Parallel() {
  const Launch launch = launch_of_this_program();
  started_ = launch.starts_mpi;
  if (started_) {
    MPI_Init(nullptr, nullptr);
    MPI_Comm_size(MPI_COMM_WORLD, &mpi_.count);
    MPI_Comm_rank(MPI_COMM_WORLD, &mpi_.own);
  }
  ranks_ = ranks_of(launch, mpi_);
  if (!is_alone()) refuse();
}

/// A launcher ends all copies as soon as one has failed: the others wait until rank 0 has spoken. Copies that MPI does
/// not know of each other cannot ask, and give it a second.
void Parallel::refuse() const {
  if (ranks_.own == 0)
    std::fprintf(stderr,
                 "error: started on %d ranks, but this version runs a scene on one; start it without mpirun "
                 "or with -n 1\n",
                 ranks_.count);
  else if (mpi_.count == 1)
    std::this_thread::sleep_for(std::chrono::seconds(1));
  if (mpi_.count > 1) MPI_Barrier(MPI_COMM_WORLD);
}

Parallel::~Parallel() {
  if (started_) MPI_Finalize();
}

}  // namespace sandglass::program

#include "sim/program/parallel.hpp"

#include "sim/base/error.hpp"

#include <cstdlib>
#include <string>

#include <mpi.h>

namespace sandglass::program {

Parallel::Parallel() {
  const char* ranks = std::getenv("OMPI_COMM_WORLD_SIZE");
  if (ranks == nullptr) return;
  if (std::string(ranks) != "1")
    throw InputError("started on " + std::string(ranks) +
                     " ranks, but this version runs a scene on one; start it without mpirun or with -n 1");
  MPI_Init(nullptr, nullptr);
  started_ = true;
}

Parallel::~Parallel() {
  if (started_) MPI_Finalize();
}

}  // namespace sandglass::program

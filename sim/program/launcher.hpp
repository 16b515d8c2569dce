#pragma once

#include <functional>

namespace sandglass::program {

/// How many copies of the program work together, and which of them this one is.
struct Ranks {
  int count = 1;
  int own = 0;
  bool operator==(const Ranks&) const = default;
};

/// What the environment says of the launcher that started this copy (mpirun, srun, ...); as it stands when there is none.
struct Launch {
  Ranks ranks;
  bool starts_mpi = false;  ///< MPI can be asked
  bool operator==(const Launch&) const = default;
};

/// The value of an environment variable, or null.
using Environment = std::function<const char*(const char*)>;

Launch launch_of(const Environment& environment);
Launch launch_of_this_program();

/// MPI's answer, unless it knows of one rank alone where the launcher started several: so it is when the launcher
/// belongs to another MPI than the one that this program was built with.
Ranks ranks_of(const Launch& launch, const Ranks& mpi);

}  // namespace sandglass::program

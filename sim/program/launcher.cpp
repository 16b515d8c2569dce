#include "sim/program/launcher.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace sandglass::program {

namespace {
struct Variables {
  const char* count;
  const char* own;
};

/// The innermost launcher first: mpirun in a Slurm step leaves the variables of the step as they are. Slurm's own say
/// nothing of MPI, which it starts through PMI or PMIx; a batch script has SLURM_NTASKS, but no SLURM_STEP_NUM_TASKS.
constexpr std::array<Variables, 5> kLaunchers = {{
    {"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},  // Open MPI
    {"MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK"},    // MVAPICH2
    {"PMI_SIZE", "PMI_RANK"},                          // MPICH, Intel MPI, srun --mpi=pmi2
    {"MPI_LOCALNRANKS", "MPI_LOCALRANKID"},            // their launcher Hydra, on this node
    {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"},          // srun
}};

/// PMIx names the rank alone: MPI must be asked for their number.
constexpr std::array kSignsOfMpi = {
    "OMPI_COMM_WORLD_SIZE", "MV2_COMM_WORLD_SIZE", "PMI_SIZE", "PMI_RANK", "PMIX_RANK", "MPI_LOCALNRANKS"};

int number(const char* text) { return text == nullptr ? 0 : std::atoi(text); }
}  // namespace

Launch launch_of(const Environment& environment) {
  Launch launch;
  const auto is_set = [&](const char* name) { return environment(name) != nullptr; };
  launch.starts_mpi = std::ranges::any_of(kSignsOfMpi, is_set);
  const auto variables = std::ranges::find_if(kLaunchers, is_set, &Variables::count);
  if (variables != kLaunchers.end())
    launch.ranks = {std::max(1, number(environment(variables->count))), number(environment(variables->own))};
  return launch;
}

Launch launch_of_this_program() {
  return launch_of([](const char* name) { return std::getenv(name); });
}

Ranks ranks_of(const Launch& launch, const Ranks& mpi) { return mpi.count > 1 ? mpi : launch.ranks; }

}  // namespace sandglass::program

#include "sim/program/launcher.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace sandglass::program::launcher_test {
namespace {

using Variables = std::map<std::string, std::string>;

Launch launch(const Variables& variables) {
  return launch_of([&](const char* name) {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
}

TEST(Launcher, NoneIsSerialAndMpiIsNotStarted) {
  EXPECT_EQ(launch({}), Launch{});
  EXPECT_EQ(launch({{"OMPI_MCA_btl", "self"}, {"PATH", "/bin"}}), Launch{});
}

TEST(Launcher, EachMpiIsRecognised) {
  const Launch second_of_four{{4, 1}, true};
  EXPECT_EQ(launch({{"OMPI_COMM_WORLD_SIZE", "4"}, {"OMPI_COMM_WORLD_RANK", "1"}}), second_of_four);
  EXPECT_EQ(launch({{"MV2_COMM_WORLD_SIZE", "4"}, {"MV2_COMM_WORLD_RANK", "1"}}), second_of_four);
  EXPECT_EQ(launch({{"PMI_SIZE", "4"}, {"PMI_RANK", "1"}}), second_of_four);
  EXPECT_EQ(launch({{"MPI_LOCALNRANKS", "4"}, {"MPI_LOCALRANKID", "1"}}), second_of_four);
}

TEST(Launcher, MpiIsAskedWhereOnlyARankIsTold) {
  EXPECT_EQ(launch({{"PMIX_RANK", "3"}}), (Launch{{1, 0}, true}));
  EXPECT_EQ(launch({{"PMI_RANK", "3"}}), (Launch{{1, 0}, true}));
}

/// A batch script is one copy, whatever the job holds; srun without MPI starts copies that know nothing of each other.
TEST(Launcher, SlurmStartsNoMpiByItself) {
  EXPECT_EQ(launch({{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "8"}}), Launch{});
  EXPECT_EQ(launch({{"SLURM_PROCID", "5"}, {"SLURM_STEP_NUM_TASKS", "8"}}), (Launch{{8, 5}, false}));
}

TEST(Launcher, TheInnermostCounts) {
  const Variables mpirun_in_a_step = {{"SLURM_STEP_NUM_TASKS", "2"},
                                      {"SLURM_PROCID", "1"},
                                      {"OMPI_COMM_WORLD_SIZE", "1"},
                                      {"OMPI_COMM_WORLD_RANK", "0"}};
  EXPECT_EQ(launch(mpirun_in_a_step), (Launch{{1, 0}, true}));
}

TEST(Launcher, WordsThatAreNoNumbersAreOneRank) {
  EXPECT_EQ(launch({{"PMI_SIZE", "many"}}), (Launch{{1, 0}, true}));
}

TEST(Launcher, MpiDecidesUnlessItMissesTheOtherCopies) {
  EXPECT_EQ(ranks_of({{1, 0}, true}, {4, 3}), (Ranks{4, 3}));
  EXPECT_EQ(ranks_of({{2, 1}, true}, {4, 3}), (Ranks{4, 3}));
  EXPECT_EQ(ranks_of({{2, 1}, true}, {1, 0}), (Ranks{2, 1}));
  EXPECT_EQ(ranks_of({}, {}), Ranks{});
}

}  // namespace
}  // namespace sandglass::program::launcher_test

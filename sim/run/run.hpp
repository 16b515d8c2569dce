#pragma once

#include "sim/record/record.hpp"
#include "sim/scene/scene.hpp"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace sandglass {

/// A small wrong change of physics or numerics, planted on purpose by the mutant suite.
/// The names are listed by mutations(); an empty name is the honest program.
struct Mutation {
  std::string name;
};
struct MutationInfo {
  std::string name;
  std::string summary;
};
const std::vector<MutationInfo>& mutations();

struct Progress {
  double fraction;          ///< of the whole run, 0 to 1
  double moves_per_second;  ///< particle-moves
  double seconds_left;      ///< from the mean of the last 20 rates
  std::uint64_t replica, step;
  double time, collisions_per_particle;
};

struct RunOptions {
  Mutation mutation;
  std::string checkpoint_path;                    ///< empty: no checkpoints
  std::function<void(const Progress&)> progress;  ///< called a few times a second at most; may be empty
  const std::atomic<bool>* stop = nullptr;  ///< set by a signal: write a checkpoint, then throw Interrupted
};

/// The run was asked to stop; a checkpoint was written when a path was given.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs every replica of the scene in this thread. The result depends on scene and seed alone.
/// Throws InputError for what the method cannot do, RunError when the state stops being a number.
Record run_scene(const Scene& scene, const RunOptions& options = {});

/// Goes on from a record that holds a State; the end is bitwise that of the uninterrupted run.
Record resume(const Record& checkpoint, const RunOptions& options = {});

/// What a scene needs and what it leaves out, before anything runs.
struct Plan {
  std::string method;
  std::uint64_t particles = 0, cells = 0, replicas = 1;
  double particles_per_cell = 0, cell_size_in_mean_free_paths = 0;
  double time_step = 0, collisions_per_particle_and_step = 0;
  double bytes_per_particle = 0;
  double steps = 0, particle_moves = 0, expected_collisions = 0;
  std::vector<std::string> columns, used, left_out;
  std::vector<std::string> warnings;  ///< e.g. cells wider than a mean free path
};
Plan plan(const Scene& scene);

}  // namespace sandglass

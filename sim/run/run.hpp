#pragma once

#include "sim/base/communicator.hpp"
#include "sim/method/plan.hpp"
#include "sim/method/planted_fault.hpp"
#include "sim/record/record.hpp"
#include "sim/scene/scene.hpp"

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace sandglass {

/// The faults that the methods of a family can be planted with. Throws InputError for a family that is not known.
const std::vector<PlantedFault>& planted_faults(const std::string& family);
/// Those of all families, each name once.
const std::vector<PlantedFault>& planted_faults();

struct Progress {
  double fraction;          ///< of the whole run, 0 to 1
  double moves_per_second;  ///< particle-moves
  double seconds_left;      ///< from the mean of the last 20 rates
  std::uint64_t replica, step;
  double time, collisions_per_particle;
};

struct RunOptions {
  std::string planted_fault;    ///< one of planted_faults() of the family; empty: the honest program
  std::string checkpoint_path;  ///< empty: no checkpoints
  std::function<void(const Progress&)> progress;  ///< called a few times a second at most; may be empty
  const std::atomic<bool>* stop = nullptr;  ///< set by a signal: write a checkpoint, then throw Interrupted
  /// Takes what a run has when it breaks, marked as broken; the error follows. May be empty.
  std::function<void(const Record&)> keep_broken;
  /// Share the work; each of them calls the same, and the first gets the record. Null: this process alone.
  Communicator* ranks = nullptr;
};

/// The run was asked to stop; a checkpoint was written when a path was given.
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(const std::string& message, bool everywhere = true)
      : std::runtime_error(message), everywhere_(everywhere) {}
  /// All ranks have stopped at this step, not this one alone.
  bool everywhere() const { return everywhere_; }

 private:
  bool everywhere_;
};

/// Runs every replica of the scene in this thread, or its share of the work. The result depends on scene and seed alone.
/// Throws InputError for what the method cannot do, RunError when the state stops being a number.
Record run_scene(const Scene& scene, const RunOptions& options = {});

/// Goes on from a record that holds a State; the end is bitwise that of the uninterrupted run.
Record resume(const Record& checkpoint, const RunOptions& options = {});

/// What a scene needs and what it leaves out, before anything runs.
Plan plan(const Scene& scene);

}  // namespace sandglass

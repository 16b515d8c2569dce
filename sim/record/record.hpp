#pragma once

#include "sim/base/columns.hpp"
#include "sim/base/particle_columns.hpp"
#include "sim/base/series.hpp"
#include "sim/record/atomic_file.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sandglass {

/// Who made a record, from what.
struct Provenance {
  std::string program_version;
  std::string commit;         ///< git commit of the source tree, with "+changes" when it was not clean
  std::string build;          ///< build type, compiler and flags
  std::string created;        ///< UTC, ISO 8601
  std::string planted_fault;  ///< empty in every honest run
};

/// The particles at one instant: position[particle][axis], row major, and the columns that the method keeps
/// beside them (sim/base/particle_columns.hpp).
struct Frame {
  std::uint64_t step = 0;
  double time = 0;
  std::vector<double> position;
  std::vector<double> velocity;
  Columns columns = {};

  std::size_t particles(int dimension) const { return position.size() / static_cast<std::size_t>(dimension); }
};

/// All samples of one replica, in the order of the scene's observers.
struct Replica {
  std::uint64_t seed = 0;
  std::vector<Series> series;
  std::map<std::string, double> counters;  ///< e.g. "collisions", "candidates", "steps", "particle-moves"
};

/// What is needed to go on, bitwise, with a run that was stopped in replica `replicas.size()`.
struct State {
  std::uint64_t step = 0;
  double time = 0;
  Frame particles;
  std::vector<Series> series;  ///< samples of the unfinished replica so far
  std::map<std::string, double> counters;
  std::map<std::string, std::vector<double>>
      memory;            ///< running sums of observers and of the method, by name
  bool changed = false;  ///< goes on with other observers than it was saved with; not kept in the file
};

/// The result of one run: everything that a check, a figure or a restart needs.
struct Record {
  std::string scene;  ///< the scene as resolved, in TOML
  Provenance provenance;
  int dimension = 2;
  std::vector<double> box_size;       ///< [dimension]
  std::vector<std::string> boundary;  ///< [dimension], "periodic" or "none" (H5MD words)
  std::vector<Replica> replicas;
  std::vector<Estimate> estimates;  ///< over all finished replicas
  std::vector<Frame> trajectory;    ///< of the first replica, when the scene asks for it
  std::map<std::string, double>
      timings;                 ///< "cpu-seconds", "wall-seconds", "peak-bytes", "bytes-per-particle", ...
  std::optional<State> state;  ///< present in checkpoints only
  std::vector<std::string> warnings;  ///< of the plan
  std::vector<std::string> changes;   ///< that were made to the scene when the run was resumed, in words
  std::string broken;                 ///< why the run ended before its time, in words; empty when it did not
};

/// Writes to a new file beside `path`, flushes it to disk and renames it: a crash leaves the previous file
/// whole. Returns the path that the record got: another than `path` where something stands there that is to be
/// kept. Throws RunError naming the path and the reason (disk full, no such folder, not writable).
std::string write_record(const std::string& path, const Record& record,
                         Existing existing = Existing::replace);

/// Throws InputError when the file is missing, truncated, not a Sandglass record, or of another schema
/// version.
Record read_record(const std::string& path);

}  // namespace sandglass

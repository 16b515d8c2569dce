#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sandglass::event_driven {

/// What the engine counts for itself, since time zero.
struct Counts {
  std::uint64_t crossings = 0;     ///< of cells
  std::uint64_t predictions = 0;   ///< searches for the next collision of a particle
  std::uint64_t guarded = 0;       ///< collisions that a collapse guard made elastic
  std::uint64_t agent_events = 0;  ///< of a particle with an agent
};

/// The row of buckets of one era: so long that a particle has about a dozen events in it, so fine that a bucket holds
/// few. Both follow from the events to come, and so go along as a gas cools.
struct Era {
  double width = HUGE_VAL;
  std::size_t buckets = 1;
  /// A cluster near collapse has most of the events to itself: the era ends after these, or what its events have left
  /// behind in the calendar would grow without bound.
  std::uint64_t most_events = std::uint64_t{1} << 53;
  double end() const { return width * static_cast<double>(buckets); }
};

/// How far a run has come. Times count from the beginning of an era, so that they keep their digits however long a run is.
struct Progress {
  double now = 0;            ///< since the origin
  double origin = 0;         ///< beginning of the era, in the time of the run
  std::uint64_t events = 0;  ///< of this era
  Era era;
  Counts counts;
  std::uint64_t exchanges = 0;  ///< particles that have come or gone in this era

  double clock() const { return origin + now; }
};

}  // namespace sandglass::event_driven

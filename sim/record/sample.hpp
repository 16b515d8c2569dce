#pragma once

#include "sim/record/record.hpp"

#include <limits>

// A small record that uses every field, for the tests of this room.

namespace sandglass {

inline Series sample_series(const Quantity& quantity, std::size_t samples) {
  Series series{quantity, {}, {}, {}};
  for (std::size_t sample = 0; sample < samples; ++sample) {
    series.step.push_back(10 * sample);
    series.time.push_back(0.1 * static_cast<double>(sample));
    for (std::size_t component = 0; component < quantity.size(); ++component)
      series.value.push_back(1.0 / static_cast<double>(1 + sample + 7 * component));
  }
  return series;
}

inline Frame sample_frame(std::uint64_t step, std::size_t particles, std::size_t dimension) {
  Frame frame{step, 0.1 * static_cast<double>(step), {}, {}};
  for (std::size_t index = 0; index < particles * dimension; ++index) {
    frame.position.push_back(0.25 + static_cast<double>(index));
    frame.velocity.push_back(1.0 / (3.0 + static_cast<double>(index)));
  }
  for (std::size_t index = 0; index < particles; ++index) frame.columns.append(column::id, 100 + index);
  return frame;
}

/// Doubles that a careless format loses.
inline std::vector<double> hard_numbers() {
  using Limits = std::numeric_limits<double>;
  return {0.0,
          -0.0,
          Limits::denorm_min(),
          -Limits::min() / 3,
          Limits::max(),
          Limits::epsilon(),
          0.1,
          Limits::infinity(),
          -Limits::infinity(),
          Limits::quiet_NaN()};
}

/// Two replicas of different length, a trajectory with a varying number of particles, and a checkpoint.
inline Record sample_record() {
  const Quantity temperature{"temperature", "mass length^2 time^-2", "granular temperature", {}, {}, {}, ""};
  const Quantity momentum{"momentum", "mass length time^-1", "total momentum", {2}, {"x", "y"}, {}, ""};
  const Quantity histogram{"velocity-histogram",    "1", "counts", {2, 3}, {}, {-1, 0, 0.5, 1},
                           "velocity [length/time]"};
  Record record;
  record.scene = "title = \"sample \xCF\x86\"\n";
  record.provenance = {"0.1.0", "abc+changes", "Release, GNU", "2000-01-01T00:00:00Z", ""};
  record.dimension = 2;
  record.box_size = {10, 20.5};
  record.boundary = {"periodic", "none"};
  for (std::size_t samples : {std::size_t{4}, std::size_t{2}}) {
    Replica replica{41 + samples, {}, {{"collisions", 12.0 * static_cast<double>(samples)}}};
    for (const Quantity& quantity : {temperature, momentum, histogram, temperature})
      replica.series.push_back(sample_series(quantity, samples));
    record.replicas.push_back(replica);
  }
  record.replicas[1].counters["rejected/above-bound"] = 1;
  record.estimates.push_back(
      {momentum, {0.5, -0.5}, {0.01, std::numeric_limits<double>::quiet_NaN()}, 17.5, 2.5, true});
  for (std::size_t particles : {std::size_t{3}, std::size_t{5}, std::size_t{4}})
    record.trajectory.push_back(sample_frame(particles * 100, particles, 2));
  record.timings = {{"cpu-seconds", 1.5}, {"peak-bytes", 1e6}};
  State state{77, 7.7, sample_frame(77, 5, 2), {sample_series(histogram, 3)}, {{"steps", 77}}, {}};
  state.particles.velocity = hard_numbers();
  state.memory = {{"sums of 50% / cells", hard_numbers()}, {"nothing", {}}};
  record.state = state;
  return record;
}

}  // namespace sandglass

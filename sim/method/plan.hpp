#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sandglass {

/// What a scene needs and what it leaves out, before anything runs.
struct Plan {
  std::string method;
  std::uint64_t particles = 0;       ///< with all that sources and inflows bring in
  std::uint64_t most_particles = 0;  ///< if all went where weights are lowest; 0 without regions
  std::uint64_t cells = 0, replicas = 1;
  double particles_per_cell = 0, cell_size_in_mean_free_paths = 0;
  double mean_free_path = 0;  ///< of a uniform gas at the initial temperature; infinite without collisions
  double time_step = 0, collisions_per_particle_and_step = 0;
  std::uint64_t density_window = 0;  ///< cells across the window of the contact factor; 0 without one
  double bytes_per_particle = 0;
  double bytes_of_samples = 0;  ///< of the observers, of all replicas: they stay in memory until the end
  double steps = 0, particle_moves = 0, expected_collisions = 0;
  std::vector<std::string> columns, used, left_out;
  std::vector<std::string> warnings;  ///< e.g. cells wider than a mean free path

  void feature(const std::string& name, bool is_used) { (is_used ? used : left_out).push_back(name); }
};

}  // namespace sandglass

#pragma once

#include "validation/check/subject.hpp"

#include <vector>

// A pipe: one axis is periodic, walls stand across the others; 'fields' cuts it into slices along that axis.

namespace sandglass {

/// The axis along a pipe of one species; -1 when the scene is no pipe.
int pipe_axis(const Scene& scene);
/// A pipe in which gravity acts, and along it alone.
bool is_falling_pipe(const Scene& scene);
/// 1 where gravity points up the axis of a falling pipe, else -1.
double sign_of_gravity(const Scene& scene);
/// A pipe of elastic particles at rest, whose walls take no energy: at equilibrium.
bool is_pipe_at_rest(const Scene& scene);

/// Simulated particles in slices of equal thickness at equal intervals of time, of one replica.
struct PipeSlices {
  std::vector<double> count;  ///< [sample * slices + slice]
  std::size_t slices = 0;
  double thickness = 0;
  double interval = 0;

  std::size_t samples() const { return count.size() / slices; }
  std::vector<double> slice(std::size_t which) const;
};

/// Samples from a time on; `slices` of them, or all bins with 0. Throws InputError when the bins do not fit, or samples
/// are not equally spaced in time.
PipeSlices pipe_slices(const Subject& subject, std::size_t replica, double from, std::size_t slices);

/// Variance of the count in a slice about its mean, over samples, slices and the given replicas.
double slice_variance(const std::vector<PipeSlices>& runs, std::span<const std::size_t> replicas);

/// Mean velocity along the pipe, and root mean square of the speed, from a time on.
double stream_velocity(const Subject& subject, std::size_t replica, double from);
double typical_speed(const Subject& subject, std::size_t replica, double from);

}  // namespace sandglass

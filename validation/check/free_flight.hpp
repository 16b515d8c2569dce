#pragma once

#include "validation/check/subject.hpp"

#include <limits>

namespace sandglass {

/// Collisions of a particle with others while it flies for `time`: the share of flights that the laws of free
/// flight miss. Without collisions 0.
double collisions_in(const Scene& scene, double time);
/// The same along a path, at the thermal speed.
double collisions_along(const Scene& scene, double length);

/// One species of smooth, elastic particles that the scene does not list, without a wave in the stream.
bool is_plain_gas(const Scene& scene);
/// No force acts.
bool is_weightless(const Scene& scene);
/// The axis along which gravity points to the low side; -1 when there is none or another force.
int vertical_axis(const Scene& scene);
bool is_periodic_along(const Scene& scene, std::size_t axis);
/// What [[wall]] says of the side, or a plain mirror.
Wall wall_at(const Scene& scene, std::size_t axis, bool high);
bool is_still(const Wall& wall);
/// The wall stands still and is thermal.
bool is_thermal_at_rest(const Wall& wall);
/// The wall stands still and is a smooth, elastic mirror.
bool is_mirror(const Wall& wall);

/// How far the centre of a particle stays from a surface.
double reach(const Scene& scene);

/// Bins along one axis, averaged over the samples from one time to another.
struct Profile {
  std::vector<double> density;
  std::vector<double> temperature;  ///< each sample with the weight of its particles less one: without bias
};

/// Throws InputError when `fields` has several bins along another axis, or no sample is late enough.
Profile profile_along(const Subject& subject, std::size_t replica, std::size_t axis, double from,
                      double to = std::numeric_limits<double>::infinity());

/// Samples of one component from a time on. Throws InputError when there is none.
std::vector<double> late_samples(const Subject& subject, std::size_t replica, const std::string& quantity,
                                 const std::string& component, double from);

}  // namespace sandglass

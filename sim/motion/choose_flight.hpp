#pragma once

#include "sim/motion/motion_kernel.hpp"
#include "sim/motion/plain_flight.hpp"
#include "sim/motion/surface_flight.hpp"

namespace sandglass::motion {

/// Calls function.template operator()<Flight, Counts>(surroundings) for what the parameters ask for. Included by the
/// files that compile a kernel for each choice.
template <class Flight, class Surroundings, class Function>
auto with_counts(const Surroundings& surroundings, bool counts, Function function) {
  if (counts) return function.template operator()<Flight, true>(surroundings);
  return function.template operator()<Flight, false>(surroundings);
}

template <int D, bool Gravity, class Function>
auto with_plain_walls(const MotionParameters<D>& parameters, Function function) {
  for (bool walled : parameters.walled)
    if (walled)
      return with_counts<PlainFlight<D, Gravity, Walls::specular>>(parameters, parameters.counts(), function);
  return with_counts<PlainFlight<D, Gravity, Walls::none>>(parameters, parameters.counts(), function);
}

template <int D, class Function>
auto choose_flight(const MotionParameters<D>& parameters, const Vector<D>& box, Function function) {
  if (parameters.has_open_side())
    return with_counts<SurfaceFlight<D, true>>(Surfaces<D>(parameters, box), parameters.counts(), function);
  if (!are_plain(parameters, box) || parameters.weighs())
    return with_counts<SurfaceFlight<D>>(Surfaces<D>(parameters, box), parameters.counts(), function);
  return parameters.gravity.isZero(0) ? with_plain_walls<D, false>(parameters, function)
                                      : with_plain_walls<D, true>(parameters, function);
}

template <int D>
std::unique_ptr<MotionStage<D>> make_motion_stage(const MotionParameters<D>& parameters,
                                                  const Vector<D>& box) {
  return choose_flight(parameters, box, []<class Flight, bool Counts>(const auto& surroundings) {
    return std::unique_ptr<MotionStage<D>>(std::make_unique<MotionKernel<Flight, Counts>>(surroundings));
  });
}

}  // namespace sandglass::motion

#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/observe/view.hpp"
#include "sim/physics/flux_sampler.hpp"

#include <vector>

namespace sandglass::event_driven {

/// A stream that leaves through a plane.
template <int D>
struct LeavingStream {
  int axis = 0;
  bool high = false;  ///< it leaves towards the high side
  Vector<D> velocity = Vector<D>::Zero();
  double temperature = 1;
  bool maxwellian =
      false;  ///< a planted fault: who comes back is drawn from Maxwell's distribution instead of its flux
};

/// Of those who come to the plane the stream sends back the share F+/F- of its two fluxes, with velocities from the flux
/// distribution of those who move against it (Baryshev 2003, 3.15 to 3.17 and 3.38): no more and no fewer than come in
/// for those who leave.
template <int D>
class Backflow {
 public:
  Backflow(const LeavingStream<D>& stream, const std::vector<SpeciesTraits>& species);

  /// Whether the particle is turned back; it then has its new velocity.
  bool turns(ParticleState<D>& particle, Random& random) const;

 private:
  struct Return {
    double share, thermal;
    StreamFlux<D> flux;
  };
  LeavingStream<D> stream_;
  std::vector<Return> returns_;  ///< of each species
};

extern template class Backflow<2>;
extern template class Backflow<3>;

}  // namespace sandglass::event_driven

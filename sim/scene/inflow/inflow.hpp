#pragma once

#include <vector>

namespace sandglass {

/// How many particles enter. poisson: as from a gas without end; even: floor(rate t) of them until time t.
enum class Arrivals { poisson, even };

/// flux: through the side, as many and as fast as the Maxwellian beyond sends them. dispenser: a piston moves in with the
/// stream, makes room for a layer and jumps back (Baryshev 2003, 3.3).
enum class InflowEntry { flux, dispenser };
/// What a piston is to those in front of it: a mirror, or a wall at the temperature of the stream.
enum class Piston { specular, thermal };

/// Planted into the scene that a run gets; no file says it.
enum class InflowFault { none, maxwellian, remainder_dropped, off_by_one };

/// An open side beyond which a gas stands that streams: what its Maxwellian sends into the box comes in.
struct Inflow {
  int axis = 0;
  bool high = false;
  std::size_t species = 0;
  double number_density = 0;     ///< of real particles beyond the side
  std::vector<double> velocity;  ///< of the stream; empty: at rest
  double temperature = 0;        ///< about it; 0: a beam
  double spin_temperature = 0;
  Arrivals arrivals = Arrivals::poisson;  ///< by flux
  InflowEntry entry = InflowEntry::flux;
  Piston piston = Piston::specular;  ///< of a dispenser
  InflowFault fault = InflowFault::none;
  bool operator==(const Inflow&) const = default;
};

}  // namespace sandglass

#pragma once

#include "sim/method/simulator.hpp"
#include "sim/physics/flux_sampler.hpp"

namespace sandglass::reservoir {

/// Faults that the mutant suite plants.
struct Faults {
  bool maxwellian = false;  ///< velocities from the Maxwellian instead of the flux distribution
  bool net_rate = false;    ///< crossings at the net rate n |U| in both directions
};

struct Parameters {
  double number_density = 1;  ///< of real particles
  double area = 1;            ///< of the plane: a length in 2D
  double stream = 0;          ///< stream speed along the normal
  double thermal = 1;         ///< sqrt(T/m)
  Faults faults;
};

/// An ideal-gas stream seen at one plane: in each step a Poisson number of particles cross, with velocities from the flux
/// distribution. It holds no particles: it is the inflow of open boundaries, alone.
template <int D>
class Reservoir final : public Simulator<D> {
 public:
  Reservoir(const Parameters& parameters, const Streams& streams, std::vector<Plane>* planes);

  void assign(const Particles<D>&) override {}
  void step(double dt, std::uint64_t step) override;
  View<D> view() override;
  std::span<const std::uint64_t> ids() const override { return {}; }
  std::uint64_t size() const override { return 0; }
  Tally& tally() override { return tally_; }
  std::size_t bytes() const override { return sizeof(*this); }

 private:
  void cross(double dt, double direction, Random random);

  Parameters parameters_;
  Streams streams_;
  std::vector<Plane>* planes_;
  Tally tally_;
};

extern template class Reservoir<2>;
extern template class Reservoir<3>;

}  // namespace sandglass::reservoir

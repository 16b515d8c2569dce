#include "sim/method/event_driven/rule.hpp"

namespace sandglass::event_driven {

template <int D>
Impact<D> CollisionRule<D>::apply_general(Gas<D>& gas, std::uint32_t first, std::uint32_t second,
                                          const Vector<D>& normal, double approach, double now,
                                          std::uint64_t& guarded) const {
  const std::size_t kind_1 = gas.kind(first), kind_2 = gas.kind(second);
  const SpeciesTraits &traits_1 = parameters_.species[kind_1], &traits_2 = parameters_.species[kind_2];
  Surface surface = parameters_.surface(kind_1, kind_2);
  if (is_guarded(gas, first, second, now, guarded)) surface.normal = {1, 0};
  Vector<D>& velocity_1 = gas.particles[first].velocity;
  Vector<D>& velocity_2 = gas.particles[second].velocity;
  Spin<D> rest_1 = Spin<D>::Zero(), rest_2 = Spin<D>::Zero();
  const bool spins = parameters_.rough;
  const Partner<D> partner_1{velocity_1, spins ? gas.spins[first] : rest_1, 1 / traits_1.mass,
                             spins ? 1 / traits_1.inertia : 0, traits_1.diameter / 2};
  const Partner<D> partner_2{velocity_2, spins ? gas.spins[second] : rest_2, 1 / traits_2.mass,
                             spins ? 1 / traits_2.inertia : 0, traits_2.diameter / 2};
  const Vector<D> before = velocity_1;
  sandglass::collide<D>(surface, normal, partner_1, partner_2);
  return {traits_1.mass * (velocity_1 - before), approach};
}

template class CollisionRule<2>;
template class CollisionRule<3>;

}  // namespace sandglass::event_driven

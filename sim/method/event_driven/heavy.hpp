#pragma once

#include "sim/method/event_driven/rule.hpp"

namespace sandglass::event_driven {

/// Collision of two particles of which at least one is heavy; the answer is as of CollisionRule::apply.
template <int D>
Impact<D> collide_with_heavy(const Parameters<D>& parameters, const CollisionRule<D>& rule, Gas<D>& gas,
                             std::uint32_t first, std::uint32_t second, const Vector<D>& normal, double now,
                             std::uint64_t& guarded);

extern template Impact<2> collide_with_heavy(const Parameters<2>&, const CollisionRule<2>&, Gas<2>&,
                                             std::uint32_t, std::uint32_t, const Vector<2>&, double,
                                             std::uint64_t&);

}  // namespace sandglass::event_driven

#pragma once

#include "sim/base/vector.hpp"

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

// A few hard balls, collision by collision. Written from conservation laws and not from the impulses of Baryshev
// (2003), Eq. 3.49-3.69, which the simulation uses: the two judge each other.

namespace sandglass::law {

/// A sphere; a disk is one that moves in the plane z = 0 and spins about z.
struct Ball {
  double mass = 1, radius = 0.5;
  double inertia = 0.1;  ///< moment of inertia
  Vector<3> position = Vector<3>::Zero(), velocity = Vector<3>::Zero(), spin = Vector<3>::Zero();
};

/// The three coefficients of a contact: normal and tangential restitution, Coulomb friction.
struct Touch {
  double restitution = 1;
  double tangential = -1;                                     ///< -1 smooth, 1 perfectly rough
  double friction = std::numeric_limits<double>::infinity();  ///< infinite: always sticks
};

/// Both balls after their collision, found from what it keeps and what it turns round. Twelve linear equations: the total
/// momentum is kept, and of each ball the angular momentum about the point of contact, since the impulse acts there; the
/// normal relative velocity turns to -e of itself; so does the tangential velocity of the contact, by e_t, unless that
/// takes more than friction can give: then the impulse points mu to one against the slip.
void collide(Ball& first, Ball& second, const Touch& touch);

using TouchOf = std::function<Touch(std::size_t, std::size_t)>;

struct FewBodyResult {
  std::vector<Ball> balls;
  std::size_t collisions = 0;
  double last_collision = 0;  ///< time
  /// Bound on the growth of a rounding error: at each collision by 1 + 2 l/(d cos a), l the relative path since the
  /// collision before, d the distance of contact, a the angle between path and line of centres (defocusing; Sinai 1970).
  double amplification = 1;
};

/// The balls at time `until`, in free flight between binary collisions, without walls or forces. Of simultaneous
/// contacts that of the lowest numbers comes first. Throws InputError after `most` collisions: collapse.
FewBodyResult few_body(std::vector<Ball> balls, const TouchOf& touch, double until,
                       std::size_t most = 1000000);

}  // namespace sandglass::law

#pragma once

#include "sim/scene/scene.hpp"
#include "validation/law/rough.hpp"

namespace sandglass {

/// q of I = q m R^2, without asking the program that is judged what it takes where the scene leaves it open.
inline double inertia_of(const Species& species, int dimension) {
  return species.inertia_factor.value_or(law::solid_inertia(dimension));
}

}  // namespace sandglass

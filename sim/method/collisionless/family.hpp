#pragma once

#include "sim/method/builder.hpp"

namespace sandglass::collisionless {

/// What the family brings to a run.
const FamilyBuilder& family();

}  // namespace sandglass::collisionless

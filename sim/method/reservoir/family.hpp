#pragma once

#include "sim/method/builder.hpp"

namespace sandglass::reservoir {

/// What the family brings to a run.
const FamilyBuilder& family();

}  // namespace sandglass::reservoir

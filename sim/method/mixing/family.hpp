#pragma once

#include "sim/method/builder.hpp"

namespace sandglass::mixing {

/// What the family brings to a run.
const FamilyBuilder& family();

}  // namespace sandglass::mixing

#pragma once

#include "sim/method/builder.hpp"

namespace sandglass::dsmc {

/// What the DSMC family brings to a run.
const FamilyBuilder& family();

}  // namespace sandglass::dsmc

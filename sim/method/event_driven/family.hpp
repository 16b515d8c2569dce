#pragma once

#include "sim/method/builder.hpp"

namespace sandglass::event_driven {

/// What the family brings to a run.
const FamilyBuilder& family();

}  // namespace sandglass::event_driven

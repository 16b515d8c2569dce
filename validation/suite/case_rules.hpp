#pragma once

#include "sim/scene/text/diagnostics.hpp"
#include "validation/suite/case.hpp"

namespace sandglass {

/// Reports every name in a case that names nothing: points, variants, checks and their numbers, tiers,
/// mutations.
void check_case_rules(const Case& subject, Diagnostics& diagnostics);

}  // namespace sandglass

#pragma once

#include "sim/record/record.hpp"

namespace sandglass {

/// This program, now: version, commit and flags are those of the last build, `created` is the present time
/// (UTC).
Provenance current_provenance();

}  // namespace sandglass

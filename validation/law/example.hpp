#pragma once

#include "validation/law/law.hpp"

namespace sandglass::law {

/// Arguments inside every range, for a first try.
Arguments example_arguments(const Law& law, int dimension = 2);

}  // namespace sandglass::law

#pragma once

#include "sim/scene/text/diagnostics.hpp"

namespace sandglass {

/// The document of a case with its [[axis]] multiplied out: each [[point]] whose name holds columns of axes in braces
/// becomes one point for every combination of their rows. A text that is one column in braces becomes the value itself.
/// Names that match 'except' are left out.
/// Reports columns that do not exist, belong to an axis that the name leaves out, or differ in length.
Node multiply_points(const Node& document, Diagnostics& diagnostics);

}  // namespace sandglass

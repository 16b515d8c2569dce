#pragma once

#include "sim/scene/method/method.hpp"

namespace sandglass {

/// Changes the collapse guard; of a method that has none, nothing.
void set_guard(Method& method, const Guard& guard);

}  // namespace sandglass

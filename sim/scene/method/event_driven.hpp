#pragma once

#include "sim/scene/method/options.hpp"
#include "sim/scene/text/words.hpp"

namespace sandglass {

const Words<CollapseGuard>& guard_words();

}  // namespace sandglass

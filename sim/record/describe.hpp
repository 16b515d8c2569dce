#pragma once

#include "sim/record/record.hpp"

namespace sandglass {

/// What a record holds, in a few lines for a terminal; ends with a line break.
std::string describe_record(const Record& record);

}  // namespace sandglass

#pragma once

#include <cstdint>

namespace sandglass::event_driven {

/// Throws InputError when there are more particles or agents than a partner's number of 32 bits can name.
void check_codes(std::uint64_t particles, std::uint64_t agents);

}  // namespace sandglass::event_driven

#pragma once

#include <atomic>

namespace sandglass::program {

/// Catches SIGINT and SIGTERM: the first sets the flag that is returned and says so on standard error unless `quiet`, the
/// second ends the program at once.
const std::atomic<bool>& stop_on_signal(bool quiet);

}  // namespace sandglass::program

#pragma once

#include <functional>
#include <vector>

namespace sandglass {

/// Runs every job, `threads` at a time, in the given order of start. The first exception stops the start of
/// further jobs and is thrown again when the running ones have ended.
void run_in_parallel(unsigned threads, const std::vector<std::function<void()>>& jobs);

}  // namespace sandglass

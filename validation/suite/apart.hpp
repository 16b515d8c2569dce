#pragma once

#include "sim/record/record.hpp"
#include "sim/run/run.hpp"

#include <functional>
#include <shared_mutex>
#include <string>

// Runs in processes of their own: one that crashes or hangs becomes a verdict, and the others go on.

namespace sandglass {

/// Held by a thread while it does anything but wait for a process. A process is made only while nobody holds it: a lock of
/// another thread would stay locked in the copy for ever.
std::shared_lock<std::shared_mutex> hold_off_new_processes();

/// Calls `work` in a process of its own. Throws RunError when it throws, crashes, or takes more than `cpu_seconds`, or twenty
/// times that by the clock; Interrupted when it does or when `stop` is set.
void run_apart(const std::function<void()>& work, double cpu_seconds, const std::atomic<bool>* stop);

/// CPU time that no run of the scene takes unless it hangs: a minute, a second a replica, and 10 us for each particle-move that
/// its plan expects, some fifty times the usual. Free flights between walls are no moves of that plan.
double cpu_limit(const Scene& scene);

/// run_scene in a process of its own, which leaves the record at `path`; a file of its own that is removed where that is empty.
Record run_scene_apart(const Scene& scene, const RunOptions& options, const std::string& path = "");

}  // namespace sandglass

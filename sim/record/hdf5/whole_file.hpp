#pragma once

#include "sim/record/atomic_file.hpp"
#include "sim/record/hdf5/writer.hpp"

#include <functional>
#include <string>

namespace sandglass::hdf5 {

/// Writes an HDF5 file that appears at `path` whole or not at all; `fill` gets its root group. Takes a
/// Session. Returns the path that it got (AtomicFile::commit). Throws RunError naming the path and the reason.
std::string write_whole_file(const std::string& path, const std::function<void(const Writer& root)>& fill,
                             Existing existing = Existing::replace);

}  // namespace sandglass::hdf5

#pragma once

#include "sim/record/hdf5/writer.hpp"

#include <functional>
#include <string>

namespace sandglass::hdf5 {

/// Writes an HDF5 file that appears at `path` whole or not at all; `fill` gets its root group. Takes a
/// Session. Throws RunError naming the path and the reason.
void write_whole_file(const std::string& path, const std::function<void(const Writer& root)>& fill);

}  // namespace sandglass::hdf5

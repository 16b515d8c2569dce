#pragma once

#include "sim/record/hdf5/handle.hpp"

#include <string>

namespace sandglass::hdf5 {

/// Creates or empties a file. The MPI-IO driver is used while MPI is initialised, the plain one otherwise: a
/// command that never starts MPI does not pay for it. Metadata carry checksums (the format of HDF5 1.8 and
/// later).
Handle create_file(const std::string& path);

/// Opens for reading. Throws Failure when the file is no HDF5 file or shorter than it says.
Handle open_file(const std::string& path);

/// How raw data travel: collective with the MPI-IO driver, plain otherwise.
Handle transfer();

}  // namespace sandglass::hdf5

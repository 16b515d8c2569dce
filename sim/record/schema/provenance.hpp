#pragma once

#include "sim/record/hdf5/reader.hpp"
#include "sim/record/hdf5/writer.hpp"
#include "sim/record/record.hpp"

namespace sandglass::schema {

void write_provenance(const hdf5::Writer& group, const Provenance& provenance);
Provenance read_provenance(const hdf5::Reader& group);

/// Throws hdf5::Failure when the file has no /sandglass group or one of a schema that this program cannot
/// read.
void require_version(const hdf5::Reader& file);

}  // namespace sandglass::schema

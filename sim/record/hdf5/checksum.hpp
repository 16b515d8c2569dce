#pragma once

#include <cstddef>

#include <hdf5.h>

namespace sandglass::hdf5 {

/// Keeps the checksum (CRC-32) of a dataset's bytes in its attribute "checksum".
void write_checksum(hid_t dataset, const void* bytes, std::size_t count);

/// Whether a dataset without a checksum is taken as it is: other programs write such.
enum class Unsealed { accept, refuse };

/// Throws Failure when the bytes are not those that were written.
void require_checksum(hid_t dataset, const void* bytes, std::size_t count, Unsealed unsealed);

}  // namespace sandglass::hdf5

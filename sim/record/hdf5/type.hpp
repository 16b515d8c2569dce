#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include <hdf5.h>

namespace sandglass::hdf5 {

/// Number of elements along each axis; empty for a scalar.
using Extents = std::vector<hsize_t>;

inline hsize_t elements(const Extents& extents) {
  hsize_t product = 1;
  for (hsize_t extent : extents) product *= extent;
  return product;
}

template <class T>
hid_t native_type() {
  if constexpr (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if constexpr (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
  if constexpr (std::is_same_v<T, std::uint8_t>) return H5T_NATIVE_UINT8;
  if constexpr (std::is_same_v<T, int>) return H5T_NATIVE_INT;
}

}  // namespace sandglass::hdf5

#include "sim/record/hdf5/checksum.hpp"

#include "sim/record/hdf5/handle.hpp"

#include <cstdint>

#include <boost/crc.hpp>

namespace sandglass::hdf5 {

namespace {
constexpr const char* name = "checksum";

std::uint32_t checksum(const void* bytes, std::size_t count) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes, count);
  return crc.checksum();
}
}  // namespace

void write_checksum(hid_t dataset, const void* bytes, std::size_t count) {
  const std::uint32_t sum = checksum(bytes, count);
  const Handle scalar(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(dataset, name, H5T_NATIVE_UINT32, scalar, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  require(H5Awrite(attribute, H5T_NATIVE_UINT32, &sum));
}

void require_checksum(hid_t dataset, const void* bytes, std::size_t count, Unsealed unsealed) {
  if (H5Aexists(dataset, name) <= 0) {
    if (unsealed == Unsealed::accept) return;
    throw Failure(
        "has no checksum: it was not written by this program, or changed since; run the scene again");
  }
  std::uint32_t sum = 0;
  const Handle attribute(H5Aopen(dataset, name, H5P_DEFAULT), H5Aclose);
  require(H5Aread(attribute, H5T_NATIVE_UINT32, &sum));
  if (sum != checksum(bytes, count))
    throw Failure("does not match its checksum: it was changed or damaged after it was written");
}

}  // namespace sandglass::hdf5

#include "sim/record/hdf5/writer.hpp"

#include "sim/record/hdf5/checksum.hpp"
#include "sim/record/hdf5/file.hpp"

#include <algorithm>

namespace sandglass::hdf5 {
namespace {

constexpr hsize_t chunk_elements = 1 << 15;  // 256 KiB of doubles
constexpr unsigned deflate_level = 1;        // higher levels cost time and gain little on doubles

Handle space_of(const Extents& extents) {
  if (extents.empty()) return Handle(H5Screate(H5S_SCALAR), H5Sclose);
  return Handle(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose);
}

Handle string_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  require(H5Tset_size(type, std::max<std::size_t>(1, length)));
  require(H5Tset_strpad(type, H5T_STR_NULLPAD));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

/// Shrinks the leading extents first, so that a chunk holds whole samples.
Extents chunk_of(Extents extents) {
  for (hsize_t& extent : extents) {
    const hsize_t rest = elements(extents) / extent;
    extent = std::clamp<hsize_t>(chunk_elements / rest, 1, extent);
  }
  return extents;
}

Handle creation(const Extents& extents, Packing packing) {
  Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (packing == Packing::plain || elements(extents) <= chunk_elements) return properties;
  const Extents chunk = chunk_of(extents);
  require(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()));
  require(H5Pset_shuffle(properties));
  require(H5Pset_deflate(properties, deflate_level));
  return properties;
}

void write_attribute(hid_t place, const std::string& name, hid_t type, const Extents& extents,
                     const void* data) {
  Handle attribute(H5Acreate2(place, name.c_str(), type, space_of(extents), H5P_DEFAULT, H5P_DEFAULT),
                   H5Aclose);
  require(H5Awrite(attribute, type, data));
}

}  // namespace

Writer Writer::group(const std::string& name) const {
  return Writer(Handle(H5Gcreate2(group_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose));
}

template <class T>
void Writer::numbers(const std::string& name, const Extents& extents, std::span<const T> values,
                     Packing packing, const T* absent) const {
  if (values.size() != elements(extents)) throw Failure("'" + name + "' does not have the size of its shape");
  const hid_t type = native_type<T>();
  const Handle properties = creation(extents, packing);
  if (absent != nullptr) require(H5Pset_fill_value(properties, type, absent));
  Handle dataset(
      H5Dcreate2(group_, name.c_str(), type, space_of(extents), H5P_DEFAULT, properties, H5P_DEFAULT),
      H5Dclose);
  if (!values.empty()) require(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, transfer(), values.data()));
  write_checksum(dataset, values.data(), values.size_bytes());
}

void Writer::text(const std::string& name, std::string_view value) const {
  Handle type = string_type(value.size());
  Handle dataset(H5Dcreate2(group_, name.c_str(), type, space_of({}), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                 H5Dclose);
  const std::string padded = value.empty() ? std::string(1, '\0') : std::string(value);
  require(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, transfer(), padded.data()));
  write_checksum(dataset, value.data(), value.size());
}

template <class T>
void Writer::attribute(const std::string& name, const std::vector<T>& values) const {
  if (!values.empty()) write_attribute(group_, name, native_type<T>(), {values.size()}, values.data());
}

void Writer::attribute(const std::string& name, int value) const {
  write_attribute(group_, name, native_type<int>(), {}, &value);
}

void Writer::attribute(const std::string& name, std::string_view value) const {
  const std::string padded = value.empty() ? std::string(1, '\0') : std::string(value);
  write_attribute(group_, name, string_type(value.size()), {}, padded.data());
}

void Writer::attribute(const std::string& name, const std::vector<std::string>& values) const {
  if (values.empty()) return;
  std::size_t length = 1;
  for (const std::string& value : values) length = std::max(length, value.size());
  std::string padded;
  for (const std::string& value : values) padded.append(value).append(length - value.size(), '\0');
  write_attribute(group_, name, string_type(length), {values.size()}, padded.data());
}

void Writer::link(const std::string& name, const Writer& source, const std::string& source_name) const {
  require(H5Lcreate_hard(source.group_, source_name.c_str(), group_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT));
}

template void Writer::numbers<double>(const std::string&, const Extents&, std::span<const double>, Packing,
                                      const double*) const;
template void Writer::numbers<std::uint64_t>(const std::string&, const Extents&,
                                             std::span<const std::uint64_t>, Packing,
                                             const std::uint64_t*) const;
template void Writer::numbers<std::uint8_t>(const std::string&, const Extents&, std::span<const std::uint8_t>,
                                            Packing, const std::uint8_t*) const;
template void Writer::attribute<double>(const std::string&, const std::vector<double>&) const;
template void Writer::attribute<std::uint64_t>(const std::string&, const std::vector<std::uint64_t>&) const;
template void Writer::attribute<int>(const std::string&, const std::vector<int>&) const;

}  // namespace sandglass::hdf5

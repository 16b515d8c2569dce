#include "sim/record/hdf5/reader.hpp"

#include "sim/record/hdf5/file.hpp"

#include <functional>

namespace sandglass::hdf5 {
namespace {

Extents extents_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  require(rank);
  Extents extents(static_cast<std::size_t>(rank));
  if (rank > 0) require(H5Sget_simple_extent_dims(space, extents.data(), nullptr));
  return extents;
}

using ReadInto = std::function<herr_t(hid_t memory_type, void* data)>;

std::vector<std::string> variable_strings(hid_t type, hid_t space, const ReadInto& read) {
  std::vector<char*> pointers(elements(extents_of(space)), nullptr);
  require(read(type, pointers.data()));
  std::vector<std::string> strings;
  for (const char* pointer : pointers) strings.emplace_back(pointer == nullptr ? "" : pointer);
  H5Dvlen_reclaim(type, space, H5P_DEFAULT, pointers.data());
  return strings;
}

std::vector<std::string> fixed_strings(hid_t type, hid_t space, const ReadInto& read) {
  const std::size_t length = H5Tget_size(type);
  std::string buffer(elements(extents_of(space)) * length, '\0');
  require(read(type, buffer.data()));
  std::vector<std::string> strings;
  for (std::size_t begin = 0; begin < buffer.size(); begin += length)
    strings.emplace_back(buffer.substr(begin, length).c_str());
  return strings;
}

std::vector<std::string> strings_of(hid_t type, hid_t space, const ReadInto& read) {
  if (H5Tget_class(type) != H5T_STRING) throw Failure("holds no text");
  return H5Tis_variable_str(type) > 0 ? variable_strings(type, space, read)
                                      : fixed_strings(type, space, read);
}

}  // namespace

void Reader::fail(const std::string& name, const std::string& reason) const {
  throw Failure("'" + path_ + name + "': " + reason);
}

Reader Reader::group(const std::string& name) const {
  if (!has(name)) fail(name, "is missing");
  return Reader(Handle(H5Gopen2(group_, name.c_str(), H5P_DEFAULT), H5Gclose), path_ + name + "/", unsealed_);
}

Reader Reader::sealed_group(const std::string& name) const {
  Reader reader = group(name);
  reader.unsealed_ = Unsealed::refuse;
  return reader;
}

bool Reader::has(const std::string& name) const { return H5Lexists(group_, name.c_str(), H5P_DEFAULT) > 0; }

bool Reader::has_attribute(const std::string& name) const { return H5Aexists(group_, name.c_str()) > 0; }

std::vector<std::string> Reader::names() const {
  std::vector<std::string> found;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    static_cast<std::vector<std::string>*>(list)->emplace_back(name);
    return 0;
  };
  require(H5Literate(group_, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &found));
  return found;
}

template <class T>
Array<T> Reader::numbers(const std::string& name) const try {
  if (!has(name)) throw Failure("is missing");
  Handle dataset(H5Dopen2(group_, name.c_str(), H5P_DEFAULT), H5Dclose);
  Array<T> array;
  array.extents = extents_of(Handle(H5Dget_space(dataset), H5Sclose));
  if (elements(array.extents) > array.values.max_size()) throw Failure("is larger than any memory");
  array.values.resize(elements(array.extents));
  if (!array.values.empty())
    require(H5Dread(dataset, native_type<T>(), H5S_ALL, H5S_ALL, transfer(), array.values.data()));
  require_checksum(dataset, array.values.data(), array.values.size() * sizeof(T), unsealed_);
  return array;
} catch (const Failure& failure) {
  fail(name, failure.what());
}

template <class T>
std::vector<T> Reader::numbers(const std::string& name, const Extents& extents) const {
  Array<T> array = numbers<T>(name);
  if (array.extents != extents) fail(name, "has another shape than the rest of the record");
  return std::move(array.values);
}

Number Reader::number_of(const std::string& name) const try {
  if (!has(name)) throw Failure("is missing");
  Handle dataset(H5Dopen2(group_, name.c_str(), H5P_DEFAULT), H5Dclose);
  Handle type(H5Dget_type(dataset), H5Tclose);
  if (H5Tget_class(type) == H5T_FLOAT) return Number::real;
  if (H5Tget_class(type) != H5T_INTEGER) throw Failure("holds no numbers");
  return H5Tget_size(type) == 1 ? Number::byte : Number::whole;
} catch (const Failure& failure) {
  fail(name, failure.what());
}

std::string Reader::text(const std::string& name) const try {
  if (!has(name)) throw Failure("is missing");
  Handle dataset(H5Dopen2(group_, name.c_str(), H5P_DEFAULT), H5Dclose);
  const auto read = [&](hid_t type, void* data) {
    return H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data);
  };
  const auto strings =
      strings_of(Handle(H5Dget_type(dataset), H5Tclose), Handle(H5Dget_space(dataset), H5Sclose), read);
  const std::string text = strings.empty() ? "" : strings.front();
  require_checksum(dataset, text.data(), text.size(), unsealed_);
  return text;
} catch (const Failure& failure) {
  fail(name, failure.what());
}

template <class T>
std::vector<T> Reader::attribute(const std::string& name) const try {
  if (!has_attribute(name)) return {};
  Handle attribute(H5Aopen(group_, name.c_str(), H5P_DEFAULT), H5Aclose);
  std::vector<T> values(elements(extents_of(Handle(H5Aget_space(attribute), H5Sclose))));
  require(H5Aread(attribute, native_type<T>(), values.data()));
  return values;
} catch (const Failure& failure) {
  fail(name, failure.what());
}

std::vector<std::string> Reader::words(const std::string& name) const try {
  if (!has_attribute(name)) return {};
  Handle attribute(H5Aopen(group_, name.c_str(), H5P_DEFAULT), H5Aclose);
  const auto read = [&](hid_t type, void* data) { return H5Aread(attribute, type, data); };
  return strings_of(Handle(H5Aget_type(attribute), H5Tclose), Handle(H5Aget_space(attribute), H5Sclose),
                    read);
} catch (const Failure& failure) {
  fail(name, failure.what());
}

std::string Reader::word(const std::string& name) const {
  const std::vector<std::string> found = words(name);
  return found.empty() ? "" : found.front();
}

template Array<double> Reader::numbers<double>(const std::string&) const;
template Array<std::uint64_t> Reader::numbers<std::uint64_t>(const std::string&) const;
template Array<std::uint8_t> Reader::numbers<std::uint8_t>(const std::string&) const;
template std::vector<double> Reader::numbers<double>(const std::string&, const Extents&) const;
template std::vector<std::uint64_t> Reader::numbers<std::uint64_t>(const std::string&, const Extents&) const;
template std::vector<std::uint8_t> Reader::numbers<std::uint8_t>(const std::string&, const Extents&) const;
template std::vector<double> Reader::attribute<double>(const std::string&) const;
template std::vector<std::uint64_t> Reader::attribute<std::uint64_t>(const std::string&) const;
template std::vector<int> Reader::attribute<int>(const std::string&) const;

}  // namespace sandglass::hdf5

#pragma once

#include "sim/base/series.hpp"
#include "sim/record/hdf5/reader.hpp"
#include "sim/record/hdf5/writer.hpp"

#include <string>
#include <vector>

namespace sandglass::schema {

/// The quantity's words and bin edges as attributes of its group.
void write_quantity(const hdf5::Writer& group, const Quantity& quantity);
Quantity read_quantity(const hdf5::Reader& group);

/// Shape of `leading` samples of the quantity.
hdf5::Extents extents_of(hdf5::Extents leading, const Quantity& quantity);

bool same(const Quantity& one, const Quantity& other);

/// A name for a link: '/' and '.', which HDF5 reads as paths, and '%' become %XX. name_of_link() is its
/// inverse.
std::string link_of_name(const std::string& name);
std::string name_of_link(const std::string& link);

/// One link per name, in their order; a repeated name gets "-2", "-3", ... added.
std::vector<std::string> links_of_names(const std::vector<std::string>& names);

/// One link per series or estimate.
template <class Item>
std::vector<std::string> links_of(const std::vector<Item>& items) {
  std::vector<std::string> names;
  for (const Item& item : items) names.push_back(item.quantity.name);
  return links_of_names(names);
}

}  // namespace sandglass::schema

#include "sim/record/schema/quantity.hpp"

#include "sim/record/schema/names.hpp"

#include <algorithm>

namespace sandglass::schema {
namespace {

constexpr const char* reserved = "/.%";

}  // namespace

void write_quantity(const hdf5::Writer& group, const Quantity& quantity) {
  group.attribute("name", quantity.name);
  group.attribute("units", quantity.units);
  group.attribute("summary", quantity.summary);
  group.attribute("shape", std::vector<std::uint64_t>(quantity.shape.begin(), quantity.shape.end()));
  group.attribute("components", quantity.components);
  group.attribute("axis", quantity.axis);
  group.attribute("axis_label", quantity.axis_label);
}

Quantity read_quantity(const hdf5::Reader& group) {
  Quantity quantity;
  quantity.name = group.word("name");
  if (quantity.name.empty()) group.fail("name", "the attribute is missing");
  quantity.units = group.word("units");
  quantity.summary = group.word("summary");
  for (std::uint64_t extent : group.attribute<std::uint64_t>("shape")) quantity.shape.push_back(extent);
  quantity.components = group.words("components");
  quantity.axis = group.attribute<double>("axis");
  quantity.axis_label = group.word("axis_label");
  return quantity;
}

hdf5::Extents extents_of(hdf5::Extents leading, const Quantity& quantity) {
  leading.insert(leading.end(), quantity.shape.begin(), quantity.shape.end());
  return leading;
}

bool same(const Quantity& one, const Quantity& other) {
  return one.name == other.name && one.units == other.units && one.summary == other.summary &&
         one.shape == other.shape && one.components == other.components && one.axis == other.axis &&
         one.axis_label == other.axis_label;
}

std::string link_of_name(const std::string& name) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string link;
  for (char letter : name) {
    if (std::string_view(reserved).find(letter) == std::string_view::npos)
      link += letter;
    else
      link.append({'%', digits[letter / 16], digits[letter % 16]});
  }
  return link;
}

std::string name_of_link(const std::string& link) {
  std::string name;
  for (std::size_t at = 0; at < link.size(); ++at) {
    const auto escaped = [&](char letter) { return link.compare(at, 3, link_of_name({letter})) == 0; };
    const char* letter = std::find_if(reserved, reserved + 3, escaped);
    name += letter == reserved + 3 ? link[at] : *letter;
    if (letter != reserved + 3) at += 2;
  }
  return name;
}

std::vector<std::string> links_of_names(const std::vector<std::string>& names) {
  std::vector<std::string> links;
  for (const std::string& name : names) {
    const std::string first = link_of_name(name);
    std::string link = first;
    for (int again = 2; std::find(links.begin(), links.end(), link) != links.end(); ++again)
      link = first + "-" + std::to_string(again);
    links.push_back(link);
  }
  return links;
}

}  // namespace sandglass::schema

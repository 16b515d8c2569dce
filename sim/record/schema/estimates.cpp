#include "sim/record/schema/names.hpp"
#include "sim/record/schema/quantity.hpp"
#include "sim/record/schema/series.hpp"

namespace sandglass::schema {
namespace {

Estimate read_estimate(const hdf5::Reader& group) {
  Estimate estimate;
  estimate.quantity = read_quantity(group);
  const hdf5::Extents extents = extents_of({}, estimate.quantity);
  estimate.value = group.numbers<double>(names::value, extents);
  estimate.standard_error = group.numbers<double>(names::standard_error, extents);
  estimate.effective_samples = group.number<double>(names::effective_samples);
  if (!group.has(names::start_time)) return estimate;  // before schema {1, 3}: the whole run
  estimate.start_time = group.number<double>(names::start_time);
  estimate.drifts = group.number<std::uint8_t>(names::drifts) != 0;
  return estimate;
}

}  // namespace

void write_estimates(const hdf5::Writer& group, const std::vector<Estimate>& estimates) {
  const std::vector<std::string> links = links_of(estimates);
  group.attribute(names::order, links);
  for (std::size_t index = 0; index < links.size(); ++index) {
    const Estimate& estimate = estimates[index];
    const hdf5::Writer element = group.group(links[index]);
    const hdf5::Extents extents = extents_of({}, estimate.quantity);
    write_quantity(element, estimate.quantity);
    element.numbers<double>(names::value, extents, estimate.value);
    element.numbers<double>(names::standard_error, extents, estimate.standard_error);
    element.number<double>(names::effective_samples, estimate.effective_samples);
    element.number<double>(names::start_time, estimate.start_time);
    element.number<std::uint8_t>(names::drifts, estimate.drifts ? 1 : 0);
  }
}

std::vector<Estimate> read_estimates(const hdf5::Reader& group) {
  std::vector<Estimate> estimates;
  for (const std::string& link : group.words(names::order))
    estimates.push_back(read_estimate(group.group(link)));
  return estimates;
}

}  // namespace sandglass::schema

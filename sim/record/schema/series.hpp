#pragma once

#include "sim/base/series.hpp"
#include "sim/record/hdf5/reader.hpp"
#include "sim/record/hdf5/writer.hpp"

#include <vector>

namespace sandglass::schema {

/// All series of one replica, in the order of the observers.
using SeriesList = std::vector<Series>;

/// One group per quantity with value[R][T][K...], time[R][T], step[R][T], samples[R], padded to the longest
/// replica. Throws hdf5::Failure when replicas do not hold the same quantities or a series does not fit its
/// own shape.
void write_series(const hdf5::Writer& group, const std::vector<const SeriesList*>& replicas);

/// One list per replica; `replicas` is how many are expected.
std::vector<SeriesList> read_series(const hdf5::Reader& group, std::size_t replicas);

/// H5MD observables: {value[T][K...], step, time} of one replica.
void write_observables(const hdf5::Writer& group, const SeriesList& replica);

void write_estimates(const hdf5::Writer& group, const std::vector<Estimate>& estimates);
std::vector<Estimate> read_estimates(const hdf5::Reader& group);

}  // namespace sandglass::schema

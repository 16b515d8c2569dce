#pragma once

#include "validation/check/subject.hpp"
#include "validation/law/obstructed_column.hpp"

#include <optional>

// A column of gas at rest under gravity between a floor and a lid, whose sides and obstacles keep it at one temperature: all
// elastic, or thermal ones among them, all as warm.

namespace sandglass {

bool is_column(const Scene& scene);

/// Temperature of the thermal surfaces; none where the gas keeps its energy.
std::optional<double> temperature_of_surfaces(const Scene& scene);

/// The run's own temperature in each replica, mean over the samples from a time on; that of the surfaces where they set it.
std::vector<double> column_temperatures(const Subject& subject, double from);
/// Of one value for each replica.
double mean_over(std::span<const std::size_t> replicas, const std::vector<double>& values);

/// The law for centres of particles, which stay their reach away from every surface.
law::ObstructedColumn column_at(const Subject& subject, double temperature);

/// What finite N and size change of density, temperature and pressure at most; `bins` along gravity in which temperatures are
/// taken.
double column_shift(const Subject& subject, double bins);

}  // namespace sandglass

#pragma once

#include "sim/base/error.hpp"
#include "sim/record/record.hpp"
#include "validation/check/check.hpp"

#include <random>
#include <string>
#include <vector>

// Hand-made records for the tests of this room: data drawn from a law, or from one that is wrong on purpose.

namespace sandglass::synthetic {

using Generator = std::mt19937_64;

/// A periodic 2D gas of disks of diameter 1 and mass 1 at temperature 1; `method` and `rest` are lines of
/// TOML.
struct GasScene {
  int particles = 1000;
  double area_fraction = 0.25;
  double restitution = 1;
  std::string initial = "";  ///< further lines of [initial]
  std::string observe = "";  ///< [[observe]] tables
  bool event_driven = false;
  double contact_time = 0;  ///< of the collapse guard; 0: none

  std::string text() const;
  law::Gas gas() const { return {2, 1, 1, 1, area_fraction, restitution}; }
};

Record record_of(const GasScene& scene, std::size_t replicas);

/// Appends an empty series to a replica and returns it; `components` empty for a scalar.
Series& add_series(Record& record, std::size_t replica, const std::string& name,
                   const std::vector<std::string>& components);
void add_sample(Series& series, double time, const std::vector<double>& values);

/// N velocities in 2D on the sphere of fixed momentum (zero) and granular temperature 1: [particle][axis],
/// row major.
std::vector<double> microcanonical(Generator& generator, int particles);

}  // namespace sandglass::synthetic

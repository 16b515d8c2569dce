#include "validation/check/pair_reference.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace sandglass {

const std::vector<PairPoint>& pair_reference() {
  static const std::vector<PairPoint> points = {
      {2500, 0.05, 0.85, 0.2048, 0.0283, 0.7527, 0.0278, 0.7467, 0.0286},
      {2500, 0.05, 0.98, 0.0027, 0.0021, 0.0001, 0.0041, 0.0003, 0.0038},
      {2500, 0.245, 0.85, 0.6316, 0.0292, 0.7789, 0.0134, 0.7349, 0.0136},
      {2500, 0.245, 0.98, 0.0001, 0.0006, 0.0103, 0.0022, 0.0095, 0.0013},
      {50000, 0.05, 0.85, 2.9069, 0.3044, 0.6806, 0.0419, 0.6736, 0.0414},
      {50000, 0.245, 0.85, 0.6969, 0.0114, 0.8036, 0.0071, 0.7731, 0.0079},
  };
  return points;
}

const PairPoint* find_pair_reference(double particles, double area_fraction, double restitution) {
  for (const PairPoint& point : pair_reference())
    if (point.particles == particles && std::abs(point.area_fraction - area_fraction) < 1e-6 &&
        std::abs(point.restitution - restitution) < 1e-6)
      return &point;
  return nullptr;
}

const PairPoint& pair_reference_at(double particles, double area_fraction, double restitution) {
  if (const PairPoint* found = find_pair_reference(particles, area_fraction, restitution)) return *found;
  std::string known;
  for (const PairPoint& point : pair_reference())
    known += fmt::format(" ({:g}, {:g}, {:g})", point.particles, point.area_fraction, point.restitution);
  throw InputError(
      fmt::format("the reference of pair correlations has no gas of {:g} particles, area fraction {:g}, "
                  "restitution {:g}: choose one of{}",
                  particles, area_fraction, restitution, known));
}

}  // namespace sandglass

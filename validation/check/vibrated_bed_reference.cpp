#include "validation/check/vibrated_bed_reference.hpp"

#include "sim/base/error.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

const std::vector<BedPoint>& vibrated_bed_reference() {
  static const std::vector<BedPoint> points = {
      {0.9, 1.0, 0.06, 0.000684, 7.2e-06},  {0.9, 1.0, 0.11, 0.0017655, 6.7e-06},
      {0.9, 1.0, 0.3, 0.0071175, 4.5e-05},  {0.9, 1.0, 0.6, 0.022937, 0.00028},
      {0.9, 1.0, 1, 0.057401, 0.00043},     {0.9, 1.0, 2, 0.22885, 0.0035},
      {0.9, 1.0, 5, 1.399, 0.026},          {0.9, 0.9, 0.06, 0.0005377, 4.6e-06},
      {0.9, 0.9, 0.11, 0.0014543, 6.4e-06}, {0.9, 0.9, 0.3, 0.0055078, 4.9e-05},
      {0.9, 0.9, 0.6, 0.014873, 9.3e-05},   {0.9, 0.9, 1, 0.031416, 0.00026},
      {0.9, 0.9, 2, 0.087908, 0.001},       {0.9, 0.9, 5, 0.32645, 0.0037},
      {0.9, 0.9, 10, 0.89925, 0.023},       {1.0, 0.9, 0.06, 0.0023228, 3.1e-05},
      {1.0, 0.9, 0.11, 0.005139, 5.8e-05},  {1.0, 0.9, 0.3, 0.016813, 9.8e-05},
      {1.0, 0.9, 0.6, 0.036229, 0.00029},   {1.0, 0.9, 1, 0.063691, 0.00056},
      {1.0, 0.9, 2, 0.14913, 0.0024},       {1.0, 0.9, 5, 0.51433, 0.005},
      {1.0, 0.9, 10, 1.4588, 0.024},        {1.0, 0.9, 20, 4.8409, 0.12},
      {1.0, 0.9, 40, 17.044, 0.25},         {1.0, 0.9, 80, 66.564, 1.7},
  };
  return points;
}

std::vector<BedPoint> reference_of(const law::VibratedBed& bed) {
  std::vector<BedPoint> found;
  if (bed.dimension != 2 || std::abs(bed.layers / 5 - 1) > 0.03) return found;
  for (const BedPoint& point : vibrated_bed_reference())
    if (std::abs(point.restitution - bed.restitution) < 1e-9 &&
        std::abs(point.wall_restitution - bed.side_restitution) < 1e-9)
      found.push_back(point);
  return found;
}

BedPoint reference_at(const law::VibratedBed& bed, double speed) {
  std::string known;
  for (const BedPoint& point : reference_of(bed)) {
    if (std::abs(point.speed / speed - 1) < 1e-3) return point;
    known += fmt::format(" {:g}", point.speed);
  }
  throw InputError(fmt::format(
      "the event-driven reference of the vibrated bed has no V = {:g} m/s at restitutions {} and {}: choose "
      "one of{}",
      speed, bed.restitution, bed.side_restitution, known.empty() ? " none" : known));
}

}  // namespace sandglass

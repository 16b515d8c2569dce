#include "validation/check/correlations_reference.hpp"

#include "sim/base/error.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

namespace sandglass {

const std::vector<CoolingPoint>& correlations_reference() {
  static const std::vector<CoolingPoint> points = {
      {0.05, 20, -2.7364, 0.0058, -2.7148, 0.0079, -2.7131, 0.0046},
      {0.05, 40, -5.3811, 0.0104, -5.3896, 0.0147, -5.3885, 0.0142},
      {0.05, 60, -7.7935, 0.0534, -7.9458, 0.0290, -7.9526, 0.0382},
      {0.05, 80, -9.6285, 0.1575, -10.2094, 0.0679, -10.2524, 0.0959},
      {0.05, 100, -10.9284, 0.2759, -12.0828, 0.1113, -12.1665, 0.1861},
      {0.05, 120, -11.9117, 0.3693, -13.5889, 0.1451, -13.7219, 0.2718},
      {0.05, 140, -12.7341, 0.4242, -14.8067, 0.1682, -15.0408, 0.3415},
      {0.245, 20, -2.6124, 0.0094, -2.6669, 0.0084, -2.6428, 0.0090},
      {0.245, 40, -4.7872, 0.0436, -5.1859, 0.0226, -5.0978, 0.0164},
      {0.245, 60, -6.1795, 0.1072, -7.1786, 0.0865, -7.0606, 0.0404},
      {0.245, 80, -6.9776, 0.1535, -8.4308, 0.1464, -8.3933, 0.0847},
      {0.245, 100, -7.5362, 0.1770, -9.2206, 0.1891, -9.2803, 0.1327},
      {0.245, 120, -7.9773, 0.1872, -9.8283, 0.2285, -9.9094, 0.1625},
      {0.245, 140, -8.3420, 0.1844, -10.3147, 0.2618, -10.4325, 0.2112},
  };
  return points;
}

const CoolingPoint& correlations_reference_at(double area_fraction, double collisions) {
  std::string known;
  for (const CoolingPoint& point : correlations_reference()) {
    if (std::abs(point.area_fraction - area_fraction) > 1e-6) continue;
    if (std::abs(point.collisions - collisions) < 1e-6) return point;
    known += fmt::format(" {:g}", point.collisions);
  }
  throw InputError(fmt::format(
      "the reference of the cooling gas has no point at area fraction {} and {:g} collisions per particle: "
      "choose one of{}",
      area_fraction, collisions, known.empty() ? " the area fractions 0.05 and 0.245" : known));
}

}  // namespace sandglass

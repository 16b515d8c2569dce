#pragma once

#include "sim/base/random.hpp"
#include "sim/method/mixing/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

// The twin: plain loops over all particles, line by line as the listing of Greenspan 1972 has them, with its names.

namespace sandglass::mixing {

/// SUPORT and ARINT: share of gravity of each particle.
inline std::vector<double> listed_shares(const std::vector<Phase<2>>& all,
                                         const SupportParameters& parameters) {
  const double bx = parameters.box[0], by = parameters.box[1], rad = 0.5 * parameters.diameter;
  const double blkx2 = 0.5 * (bx / parameters.columns), blky = by / parameters.rows;
  const auto arint = [&](std::size_t jp, double x1, double x2, double y1, double y2) {
    double area = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i == jp) continue;
      const double al = std::max(0.0, all[i].position[0] - rad), ar = std::min(bx, all[i].position[0] + rad);
      const double bl = std::max(0.0, all[i].position[1] - rad), br = std::min(by, all[i].position[1] + rad);
      if (ar < x1 || al > x2 || all[i].position[1] > all[jp].position[1]) continue;
      const double f1 = std::min(br, y2) - std::max(bl, y1);
      if (!(f1 > 0)) continue;
      const double f2 = std::min(ar, x2) - std::max(al, x1);
      if (!(f2 > 0)) continue;
      area += f1 * f2;
    }
    return area;
  };
  std::vector<double> shares;
  for (std::size_t jp = 0; jp < all.size(); ++jp) {
    const double x = all[jp].position[0], y = all[jp].position[1];
    const double xl = std::max(0.0, x - blkx2), xu = std::min(bx, x + blkx2);
    std::uint32_t kay = parameters.rows;
    for (std::uint32_t k = 1; k < parameters.rows; ++k)
      if (y < k * blky) {
        kay = k;
        break;
      }
    if (kay == 1) {
      const double as = arint(jp, xl, xu, 0, y);
      shares.push_back(
          y > parameters.diameter ? as > 0 ? 1 - as / (y * (xu - xl) + parameters.smallest_length) : 1 : 0);
      continue;
    }
    double aa = 0;
    bool empty = false;
    for (std::uint32_t k = 2; k <= kay && !empty; ++k) {
      const double as = arint(jp, xl, xu, (k - 2) * blky, (k - 1) * blky);
      empty = !(as > 0);
      aa += as;
    }
    shares.push_back(empty ? 1 : 1 - aa / ((kay - 1) * blky * (xu - xl) + parameters.smallest_length));
  }
  return shares;
}

/// ACCEL without gravity; powers by the mathematical library.
inline std::vector<Vector<2>> listed_accelerations(const std::vector<Phase<2>>& all,
                                                   const std::vector<double>& mass, const Repulsion& law) {
  std::vector<Vector<2>> ac(all.size(), Vector<2>::Zero());
  for (std::size_t j = 0; j + 1 < all.size(); ++j)
    for (std::size_t i = j + 1; i < all.size(); ++i) {
      const double r =
          std::hypot(all[i].position[0] - all[j].position[0], all[i].position[1] - all[j].position[1]);
      if (!(r < law.cutoff)) continue;
      const double soft = r + law.softening_length;
      double d = std::pow(soft, static_cast<double>(law.exponent));
      if (r < law.diameter) d *= std::pow(soft / law.diameter, static_cast<double>(law.core_exponent));
      const Vector<2> t = (all[j].position - all[i].position) / d;
      ac[j] += law.coefficient * mass[i] * t;
      ac[i] -= law.coefficient * mass[j] * t;
    }
  return ac;
}

inline std::vector<Phase<2>> random_particles(const Vector<2>& box, std::size_t count, std::uint64_t seed) {
  Random random(StreamKey(seed, Purpose::positions, 0, 0), 0);
  std::vector<Phase<2>> particles;
  for (std::size_t i = 0; i < count; ++i)
    particles.push_back({{box[0] * random.uniform(), box[1] * random.uniform()},
                         {200 * random.uniform() - 100, 200 * random.uniform() - 100}});
  return particles;
}

}  // namespace sandglass::mixing

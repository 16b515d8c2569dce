#include "validation/check/collapse_reference.hpp"

#include "sim/base/error.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
using Points = std::vector<CollapsePoint>;

const Points& of_restitution(double restitution, const Points& weak, const Points& strong) {
  if (std::abs(restitution - 0.9) < 1e-9) return weak;
  if (std::abs(restitution - 0.5) < 1e-9) return strong;
  throw InputError(
      fmt::format("the reference of the collapse has restitution 0.9 and 0.5, not {}", restitution));
}
}  // namespace

const Points& collapse_lift(double restitution) {
  static const Points weak = {
      {0.02, 8.21e-5, 2.9e-6},
      {0.03, 3.754e-4, 8.3e-6},
      {0.04, 1.119e-3, 1.7e-5},
      {0.05, 2.618e-3, 3.0e-5},
  };
  static const Points strong = {
      {0.02, 6.0e-5, 1.4e-5},
      {0.03, 3.02e-4, 2.8e-5},
      {0.04, 9.29e-4, 6.3e-5},
      {0.05, 2.228e-3, 1.5e-4},
  };
  return of_restitution(restitution, weak, strong);
}

const Points& collapse_height(double restitution) {
  static const Points weak = {
      {0.1, 5.080e-3, 1.4e-5}, {0.15, 3.905e-3, 1.7e-5}, {0.2, 2.842e-3, 9e-6}, {0.3, 2.360e-3, 1.2e-5},
      {0.4, 2.353e-3, 4e-6},   {0.5, 2.334e-3, 4e-6},    {0.6, 2.331e-3, 5e-6},
  };
  static const Points strong = {
      {0.1, 2.487e-3, 7e-6},
      {0.15, 2.345e-3, 1.1e-5},
  };
  return of_restitution(restitution, weak, strong);
}

}  // namespace sandglass

#pragma once

#include <array>
#include <vector>

namespace sandglass {

/// open: particles leave by it for good.
enum class Side { periodic, specular, open };

struct Domain {
  int dimension = 2;
  std::vector<double> size;                ///< edge lengths; the low corner is the origin
  std::vector<std::array<Side, 2>> sides;  ///< per axis: low side, high side; periodic comes in pairs
  bool operator==(const Domain&) const = default;
};

double volume(const Domain& domain);
bool has_open_side(const Domain& domain);

}  // namespace sandglass

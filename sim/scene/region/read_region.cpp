#include "sim/scene/read_sections.hpp"

namespace sandglass {

void read_region(Table& table, Region& region) {
  table.require("low", region.low, "the low corner, one coordinate for each axis");
  table.require("high", region.high, "the high corner, one coordinate for each axis");
  table.require("weight", region.weight, "real particles per simulated one in this region");
  table.finish();
}

}  // namespace sandglass

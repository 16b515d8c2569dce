#include "sim/scene/write_sections.hpp"

namespace sandglass {

void write_region(Lines& lines, const Region& region) {
  lines.header("[[region]]");
  lines.add("low", region.low);
  lines.add("high", region.high);
  lines.add("weight", region.weight);
}

}  // namespace sandglass

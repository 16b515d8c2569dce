#include "sim/scene/read_sections.hpp"

namespace sandglass {

void read_outflow(Table& table, Outflow& outflow) {
  read_side(table, outflow.axis, outflow.high);
  table.read("velocity", outflow.velocity);
  table.require("temperature", outflow.temperature, "granular temperature of the stream beyond the side");
  table.read("filter", outflow.filter);
  table.finish();
}

}  // namespace sandglass

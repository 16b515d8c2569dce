#include "sim/scene/read_sections.hpp"

namespace sandglass {

void read_source(Table& table, Source& source) {
  table.require("rate", source.rate, "particles per time, for example rate = 1.0");
  table.read("count", source.count);
  table.read("height", source.height);
  table.require("centre", source.centre,
                source.height ? "one coordinate for each axis but that of gravity, for example centre = [5.0]"
                              : "one coordinate for each axis, for example centre = [5.0, 9.0]");
  table.read("width", source.width);
  table.read("velocity", source.velocity);
  table.finish();
}

}  // namespace sandglass

#include "sim/scene/write_sections.hpp"

namespace sandglass {

void write_source(Lines& lines, const Source& source) {
  lines.header("[[source]]");
  lines.add("rate", source.rate);
  lines.add("count", source.count);
  lines.add("height", source.height);
  lines.add("centre", source.centre);
  if (!source.width.empty()) lines.add("width", source.width);
  if (!source.velocity.empty()) lines.add("velocity", source.velocity);
}

}  // namespace sandglass

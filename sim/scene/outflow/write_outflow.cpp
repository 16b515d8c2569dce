#include "sim/scene/words.hpp"
#include "sim/scene/write_sections.hpp"

namespace sandglass {

void write_outflow(Lines& lines, const Outflow& outflow) {
  lines.header("[[outflow]]");
  lines.add("side", word_of(wall_side_words(), std::pair{outflow.axis, outflow.high}));
  if (!outflow.velocity.empty()) lines.add("velocity", outflow.velocity);
  lines.add("temperature", outflow.temperature);
  lines.add("filter", outflow.filter);
}

}  // namespace sandglass

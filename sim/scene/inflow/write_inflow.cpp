#include "sim/scene/words.hpp"
#include "sim/scene/write_sections.hpp"

namespace sandglass {

void write_inflow(Lines& lines, const Inflow& inflow, const Scene& scene) {
  lines.header("[[inflow]]");
  lines.add("side", word_of(wall_side_words(), std::pair{inflow.axis, inflow.high}));
  lines.add("species", scene.species.at(inflow.species).name);
  lines.add("number-density", inflow.number_density);
  if (!inflow.velocity.empty()) lines.add("velocity", inflow.velocity);
  lines.add("temperature", inflow.temperature);
  lines.add("spin-temperature", inflow.spin_temperature);
  lines.add("entry", word_of(entry_words(), inflow.entry));
  if (inflow.entry == InflowEntry::flux)
    lines.add("arrivals", word_of(arrivals_words(), inflow.arrivals));
  else
    lines.add("piston", word_of(piston_words(), inflow.piston));
}

}  // namespace sandglass

#include "sim/scene/read_sections.hpp"
#include "sim/scene/words.hpp"

namespace sandglass {

void read_inflow(Table& table, const std::vector<Species>* species, Inflow& inflow) {
  read_side(table, inflow.axis, inflow.high);
  read_species_name(table, species, inflow.species);
  table.require("number-density", inflow.number_density,
                "real particles per area or volume of the gas beyond the side");
  table.read("velocity", inflow.velocity);
  table.require("temperature", inflow.temperature, "granular temperature of the stream; 0 is a beam");
  table.read("spin-temperature", inflow.spin_temperature);
  table.read_word("arrivals", "way to arrive", inflow.arrivals, arrivals_words());
  table.finish();
}

}  // namespace sandglass

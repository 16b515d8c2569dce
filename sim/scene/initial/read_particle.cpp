#include "sim/scene/read_sections.hpp"

namespace sandglass {

namespace {
/// One component in two dimensions, where the axis of every spin is normal to the plane.
void read_spin(Table& table, int dimension, std::vector<double>& spin) {
  if (dimension == 0) return table.skip("spin");
  if (dimension == 3) return table.read("spin", spin);
  std::optional<double> value;
  table.read("spin", value);
  if (value) spin = {*value};
}
}  // namespace

void read_species_name(Table& table, const std::vector<Species>* species, std::size_t& index) {
  if (species == nullptr) return table.skip("species");
  Words<std::size_t> words;
  for (std::size_t i = 0; i < species->size(); ++i) words.emplace_back((*species)[i].name, i);
  table.read_word("species", "species", index, words);
}

void read_particle(Table& table, int dimension, const std::vector<Species>* species,
                   GivenParticle& particle) {
  table.require("position", particle.position, "one coordinate for each axis");
  table.require("velocity", particle.velocity, "one component for each axis");
  read_spin(table, dimension, particle.spin);
  read_species_name(table, species, particle.species);
  table.finish();
}

}  // namespace sandglass

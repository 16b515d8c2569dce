#include "sim/scene/read_sections.hpp"

namespace sandglass {

namespace {
void read_shear_wave(Table& table, std::optional<ShearWave>& wave) {
  wave.emplace();
  table.require("amplitude", wave->amplitude, "largest velocity of the wave");
  table.read("periods", wave->periods);
  table.finish();
}
}  // namespace

void read_forces(Table& table, std::vector<double>& gravity) {
  table.read("gravity", gravity);
  table.finish();
}

void read_initial(Table& table, Initial& initial) {
  table.read_word("positions", "choice of positions", initial.positions, positions_words());
  table.read("temperature", initial.temperature);
  table.read("velocity", initial.velocity);
  table.read("exact", initial.exact);
  if (std::optional<Table> wave = table.table("shear-wave")) read_shear_wave(*wave, initial.shear_wave);
  table.read("equilibrate-collisions-per-particle", initial.equilibrate_collisions);
  table.finish();
}

}  // namespace sandglass

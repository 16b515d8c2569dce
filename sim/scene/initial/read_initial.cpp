#include "sim/scene/read_sections.hpp"
#include "sim/scene/words.hpp"

namespace sandglass {

namespace {
void read_shear_wave(Table& table, std::optional<ShearWave>& wave) {
  wave.emplace();
  table.require("amplitude", wave->amplitude, "largest velocity of the wave");
  table.read("periods", wave->periods);
  table.finish();
}

void refuse_temperature(Table& table) {
  for (const std::string key : {"temperature", "exact"})
    table.refuse(key,
                 "cannot be used with 'uniform-velocity', which draws velocities evenly; remove one of them");
}

void refuse_sampling(Table& table) {
  const std::string reason =
      "cannot be used with positions = \"given\", where each [[particle]] has its own velocity; remove it";
  for (const std::string key :
       {"temperature", "velocity", "exact", "shear-wave", "equilibrate-collisions-per-particle",
        "spin-temperature", "uniform-velocity"})
    table.refuse(key, reason);
  table.finish();
}
}  // namespace

void read_forces(Table& table, std::vector<double>& gravity) {
  table.read("gravity", gravity);
  table.finish();
}

bool read_initial(Table& table, Initial& initial) {
  std::optional<Positions> positions = initial.positions;
  table.read_word("positions", "choice of positions", positions, positions_words());
  if (!positions) {
    table.read("velocity-rounding", initial.velocity_rounding);
    refuse_sampling(table);
    return true;
  }
  initial.positions = *positions;
  table.read("uniform-velocity", initial.uniform_velocity);
  if (table.has("uniform-velocity")) {
    refuse_temperature(table);
  } else {
    table.read("temperature", initial.temperature);
    table.read("exact", initial.exact);
  }
  table.read("velocity", initial.velocity);
  table.refuse("velocity-rounding",
               "is for positions = \"given\", whose velocities are printed numbers; remove it");
  if (std::optional<Table> wave = table.table("shear-wave")) read_shear_wave(*wave, initial.shear_wave);
  table.read("equilibrate-collisions-per-particle", initial.equilibrate_collisions);
  table.read("spin-temperature", initial.spin_temperature);
  table.finish();
  return false;
}

}  // namespace sandglass

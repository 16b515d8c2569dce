#include "sim/scene/method/family.hpp"

namespace sandglass {

namespace {
const std::string stream = "the method 'reservoir' draws an ideal-gas stream and ";

void read(Table&, MethodOptions&) {}
void write(Lines&, const MethodOptions&) {}

void check(const Scene& scene, Diagnostics& diagnostics) {
  const auto refuse = [&diagnostics](bool wrong, const std::string& path, const std::string& reason) {
    if (wrong && diagnostics.clean(path)) diagnostics.report(path, stream + reason);
  };
  if (!scene.species.empty())
    refuse(!scene.species.front().number_density, "species[0]", "needs 'number-density' for its density");
  refuse(scene.observe.empty(), "observe", "needs the observer 'crossings'");
}

MethodFamily make_family() {
  MethodFamily family;
  family.name = "reservoir";
  family.can.particles = false;
  family.can.collisions = false;
  family.can.weights = true;
  family.can.walls = false;
  family.can.gravity = false;
  family.can.restartable = false;
  family.presets = {
      {{"reservoir", "no box: velocities of an ideal-gas stream through a plane, from the flux distribution"},
       ReservoirOptions{}}};
  family.refused = {
      {{"contact-factor", "density", "offset", "random-offset", "pair-count"},
       "is not used by the method 'reservoir', which has no collisions; remove it"},
      {{"cells", "cell-size"}, "is not used by the method 'reservoir', which has no cells; remove it"}};
  family.neutral = {{"contact-factor", "none"}, {"density", "smoothed"}, {"offset", "none"}};
  family.read = read;
  family.write = write;
  family.check = check;
  return family;
}
}  // namespace

const MethodFamily& reservoir_family() {
  static const MethodFamily family = make_family();
  return family;
}

}  // namespace sandglass

#include "sim/scene/method/family.hpp"

namespace sandglass {

namespace {
void read(Table&, MethodOptions&) {}
void write(Lines&, const MethodOptions&) {}
void check(const Scene&, Diagnostics&) {}

MethodFamily make_family() {
  using enum SurfaceKind;
  MethodFamily family;
  family.name = "collisionless";
  family.can.collisions = false;
  family.can.weights = true;
  family.can.ranks = true;
  family.can.wall_rules = {specular, bounce_back, random_tangential_sign, thermal};
  family.can.obstacles = true;
  family.can.varying_number = true;
  family.presets = {{{"collisionless", "free flight between walls, obstacles and planes: the Knudsen limit"},
                     CollisionlessOptions{}}};
  family.read = read;
  family.write = write;
  family.check = check;
  return family;
}
}  // namespace

const MethodFamily& collisionless_family() {
  static const MethodFamily family = make_family();
  return family;
}

}  // namespace sandglass

#include "sim/method/boundary_faults.hpp"

#include <algorithm>

namespace sandglass {

namespace {
template <class Change>
void change_surfaces(Scene& scene, Change change) {
  for (Wall& wall : scene.walls) change(wall.surface);
  for (Obstacle& obstacle : scene.obstacles) change(obstacle.surface);
}

/// A table for each mirror that the scene says no more of.
void name_mirrors(Scene& scene) {
  for (int axis = 0; axis < static_cast<int>(scene.domain.sides.size()); ++axis)
    for (const bool high : {false, true}) {
      const auto here = [&](const Wall& wall) { return wall.axis == axis && wall.high == high; };
      const Side side = scene.domain.sides[static_cast<std::size_t>(axis)][high ? 1 : 0];
      if (side != Side::specular || std::ranges::any_of(scene.walls, here)) continue;
      scene.walls.emplace_back();
      scene.walls.back().axis = axis;
      scene.walls.back().high = high;
    }
}

void scale_gravity(Scene& scene, double factor) {
  for (double& component : scene.gravity) component *= factor;
}
}  // namespace

const std::vector<FaultEntry<SceneChange>>& boundary_faults() {
  static const std::vector<FaultEntry<SceneChange>> all = {
      {{"gravity-plus-1-percent", "gravity 1% too strong"}, [](Scene& scene) { scale_gravity(scene, 1.01); }},
      {{"gravity-reversed", "gravity with the wrong sign"}, [](Scene& scene) { scale_gravity(scene, -1); }},
      {{"wall-restitution-plus-2-percent", "restitution of walls and obstacles 2% too large, at most 1"},
       [](Scene& scene) {
         change_surfaces(scene, [](SurfaceRule& surface) {
           surface.restitution = std::min(1.0, 1.02 * surface.restitution);
         });
       }},
      {{"wall-restitution-dropped", "walls and obstacles lose no energy of the normal motion"},
       [](Scene& scene) { change_surfaces(scene, [](SurfaceRule& surface) { surface.restitution = 1; }); }},
      {{"mirrors-lose-2-percent", "specular walls keep 2% less of the normal velocity"},
       [](Scene& scene) {
         name_mirrors(scene);
         for (Wall& wall : scene.walls)
           if (wall.surface.rule == SurfaceKind::specular) wall.surface.restitution *= 0.98;
       }},
      {{"thermal-surfaces-draw-maxwellian",
        "normal velocities from thermal walls and obstacles are Maxwell's instead of its flux"},
       [](Scene& scene) {
         change_surfaces(scene, [](SurfaceRule& surface) {
           if (surface.rule == SurfaceKind::thermal) surface.probability = 0;
         });
       }},
      {{"thermal-surfaces-reflect", "thermal walls and obstacles are mirrors"},
       [](Scene& scene) {
         change_surfaces(scene, [](SurfaceRule& surface) {
           if (surface.rule == SurfaceKind::thermal) surface = {};
         });
       }},
      {{"wall-temperature-plus-10-percent", "thermal walls and obstacles at 1.1 times their temperature"},
       [](Scene& scene) {
         change_surfaces(scene, [](SurfaceRule& surface) { surface.temperature *= 1.1; });
       }},
      {{"high-walls-lossless", "walls at the high sides lose no energy of the normal motion"},
       [](Scene& scene) {
         for (Wall& wall : scene.walls)
           if (wall.high) wall.surface.restitution = 1;
       }},
      {{"wall-temperature-plus-20-percent", "thermal walls and obstacles at 1.2 times their temperature"},
       [](Scene& scene) {
         change_surfaces(scene, [](SurfaceRule& surface) { surface.temperature *= 1.2; });
       }},
      {{"bounce-back-probability-ignored", "every particle bounces back"},
       [](Scene& scene) { change_surfaces(scene, [](SurfaceRule& surface) { surface.probability = 1; }); }},
      {{"wall-velocity-dropped", "walls stand still, their vibration aside"},
       [](Scene& scene) {
         for (Wall& wall : scene.walls) wall.velocity.clear();
       }},
      {{"obstacle-radius-plus-2-percent", "obstacles 2% too large"},
       [](Scene& scene) {
         for (Obstacle& obstacle : scene.obstacles) obstacle.radius *= 1.02;
       }},
  };
  return all;
}

const std::vector<FaultEntry<SceneChange>>& exchange_faults() {
  static const std::vector<FaultEntry<SceneChange>> all = {
      {{"open-sides-reflect", "open sides are smooth, elastic walls"},
       [](Scene& scene) {
         for (auto& sides : scene.domain.sides) std::ranges::replace(sides, Side::open, Side::specular);
       }},
      {{"source-rate-minus-10-percent", "sources pour 10% too slowly"},
       [](Scene& scene) {
         for (Source& source : scene.sources) source.rate *= 0.9;
       }},
      {{"inflows-draw-maxwellian", "normal velocities of inflows are Maxwell's instead of its flux"},
       [](Scene& scene) {
         for (Inflow& inflow : scene.inflows) inflow.fault = InflowFault::maxwellian;
       }},
      {{"inflow-drift-dropped", "inflows come from gases at rest"},
       [](Scene& scene) {
         for (Inflow& inflow : scene.inflows) inflow.velocity.clear();
       }},
      {{"inflow-remainder-dropped", "inflows let in whole particles of each step and forget the rest"},
       [](Scene& scene) {
         for (Inflow& inflow : scene.inflows) inflow.fault = InflowFault::remainder_dropped;
       }},
      {{"inflow-off-by-one", "inflows count one particle too few in each step, and draw it once more"},
       [](Scene& scene) {
         for (Inflow& inflow : scene.inflows) inflow.fault = InflowFault::off_by_one;
       }},
  };
  return all;
}

const std::vector<FaultEntry<SceneChange>>& step_faults() {
  static const std::vector<FaultEntry<SceneChange>> all = {
      {{"cell-fraction-times-5", "steps five times as long as their part of a cell allows"},
       [](Scene& scene) {
         if (auto& fraction = scene.method.time_step.cell_fraction) *fraction *= 5;
       }},
  };
  return all;
}

Scene with_scene_fault(const Scene& scene, const std::string& name) {
  Scene faulty = scene;
  plant(boundary_faults(), name, faulty);
  plant(exchange_faults(), name, faulty);
  plant(step_faults(), name, faulty);
  return faulty;
}

}  // namespace sandglass

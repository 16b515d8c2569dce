#pragma once

#include "sim/scene/scene.hpp"

namespace sandglass {

inline DsmcOptions& dsmc_options(Scene& scene) { return std::get<DsmcOptions>(scene.method.options); }

/// A gas in a periodic box with a fixed step, to be changed by a test.
inline Scene test_scene(int dimension, double edge, std::uint64_t count) {
  Scene scene;
  scene.domain.dimension = dimension;
  scene.domain.size.assign(static_cast<std::size_t>(dimension), edge);
  scene.domain.sides.assign(static_cast<std::size_t>(dimension), {Side::periodic, Side::periodic});
  scene.species.resize(1);
  scene.species[0].count = count;
  scene.method.time_step.fixed = 0.05;
  scene.run.duration.steps = 10;
  return scene;
}

}  // namespace sandglass

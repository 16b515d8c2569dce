#include "sim/motion/test_march.hpp"
#include "sim/space/flight.hpp"

#include <gtest/gtest.h>

// The flight between walls and obstacles against twins.

namespace sandglass::motion::surface_twin_test {
namespace {

WallRule specular(double restitution) { return {WallKind::specular, {{restitution}}, 1, 1}; }
/// Does what a smooth elastic wall does, but is not the plain kernel's.
const WallRule kElasticInDisguise = {WallKind::bounce_back, {}, 0, 1};

template <int D>
Vector<D> distance(const Vector<D>& a, const Vector<D>& b, const MotionParameters<D>& parameters) {
  Vector<D> d = a - b;
  for (int axis = 0; axis < D; ++axis)
    if (!parameters.walled[static_cast<std::size_t>(axis)])
      d[axis] -= box<D>()[axis] * std::round(d[axis] / box<D>()[axis]);
  return d;
}

template <int D>
MotionParameters<D> everything(int code) {
  MotionParameters<D> parameters;
  parameters.walled[D - 1] = true;
  parameters.walled[0] = code & 1;
  if (code & 2) parameters.gravity[D - 1] = -1.3;
  if (code & 4) parameters.gravity[0] = 0.8;
  parameters.obstacles = some_obstacles<D>(specular(0.8));
  WallPlace<D> floor = wall<D>(D - 1, false, specular(0.9));
  floor.amplitude = 0.06, floor.frequency = 2.5;
  WallPlace<D> lid = wall<D>(D - 1, true, specular(0.7));
  lid.velocity[D - 1] = code & 8 ? 0.5 : -0.2;
  parameters.walls = {floor, lid};
  return parameters;
}

/// In front of every surface at this time.
template <int D>
bool is_free(const Vector<D>& x, const MotionParameters<D>& parameters) {
  for (const ObstaclePlace<D>& obstacle : parameters.obstacles)
    if ((x - obstacle.centre).norm() < obstacle.radius + 1e-3) return false;
  return x[D - 1] > 0.07 && x[D - 1] < box<D>()[D - 1] - 0.1;
}

/// Rounding grows at each hit on a round surface: particles with many hits are compared less sharply.
template <int D>
void expect_like_march(int code) {
  const MotionParameters<D> parameters = everything<D>(code);
  auto store = scattered<D>(3, 0, 80);
  const MotionStep step{0.4, 0.17};
  std::vector<Phase<D>> before(store.phases().begin(), store.phases().end());
  advance(*make_motion_stage<D>(parameters, box<D>()), store, step);
  int hits = 0;
  for (std::size_t i = 0; i < store.size(); ++i) {
    if (!is_free<D>(before[i].position, parameters)) continue;
    March<D> march(parameters, step);
    const Phase<D> expected = march.fly(before[i]), is = store.phases()[i];
    hits += march.hits;
    const double tolerance = 1e-11 * std::pow(20, march.hits);
    ASSERT_LT(distance<D>(is.position, expected.position, parameters).norm(), tolerance) << march.hits;
    ASSERT_LT((is.velocity - expected.velocity).norm(), 10 * tolerance) << march.hits;
  }
  EXPECT_GT(hits, 6);
}

TEST(SurfaceFlight, AgreesWithATwinOfLittleStepsInTwoDimensions) {
  for (int code = 0; code < 16; ++code) expect_like_march<2>(code);
}
TEST(SurfaceFlight, AgreesWithATwinOfLittleStepsInThreeDimensions) {
  for (int code = 0; code < 16; ++code) expect_like_march<3>(code);
}

/// Elastic walls at rest: the plain kernel is the twin.
template <int D>
void expect_like_plain(int code, int pulled, double dt) {
  MotionParameters<D> parameters;
  for (int axis = 0; axis < D; ++axis) parameters.walled[static_cast<std::size_t>(axis)] = code >> axis & 1;
  if (pulled >= 0) parameters.gravity[pulled] = -0.7;
  auto plain = scattered<D>(3), general = scattered<D>(3);
  advance(*make_motion_stage<D>(parameters, box<D>()), plain, {dt});
  for (int axis = 0; axis < D; ++axis)
    if (code >> axis & 1) parameters.walls.push_back(wall<D>(axis, false, kElasticInDisguise));
  advance(*make_motion_stage<D>(parameters, box<D>()), general, {dt});
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const Phase<D>&is = general.phases()[i], &expected = plain.phases()[i];
    ASSERT_LT(distance<D>(is.position, expected.position, parameters).norm(), 1e-11);
    ASSERT_LT((is.velocity - expected.velocity).norm(), 1e-11);
    ASSERT_EQ(general.places()[i].cell, general.grid().cell_of(is.position));
  }
}

template <int D>
void expect_like_plain() {
  for (int code = 1; code < 1 << D; ++code)
    for (int pulled = -1; pulled < D; ++pulled)
      for (double dt : {1e-3, 0.3, 5.0}) expect_like_plain<D>(code, pulled, dt);
}
TEST(SurfaceFlight, AgreesWithThePlainKernel) {
  expect_like_plain<2>();
  expect_like_plain<3>();
}

/// Passages of a plane by paths that obstacles and a vibrating wall turn back.
template <int D>
void expect_passages(double plane, int code) {
  MotionParameters<D> parameters = everything<D>(code);
  auto store = scattered<D>(4, 0, 300);
  std::vector<Plane> planes{{0, plane, {-20, 0, 20}}};
  parameters.planes = &planes;
  int up = 0, down = 0;
  const MotionStep step{0.9, 0.1};
  for (Phase<D>& particle : store.phases())
    if (!is_free<D>(particle.position, parameters)) particle = {Vector<D>::Constant(0.9), Vector<D>::Ones()};
  for (const Phase<D>& particle : store.phases()) {
    typename March<D>::Passages passages;
    March<D>(parameters, step).fly(particle, 0, plane, &passages);
    up += passages.up, down += passages.down;
  }
  advance(*make_motion_stage<D>(parameters, box<D>()), store, step);
  EXPECT_GT(up, 20);
  EXPECT_EQ(planes[0].up(), up);
  EXPECT_EQ(planes[0].down(), down);
}
TEST(SurfaceFlight, CountsPassagesAlongThePath) {
  expect_passages<2>(0.5, 2);  // through an obstacle
  expect_passages<3>(1.5, 2);
}
TEST(SurfaceFlight, CountsPassagesOfPathsThatGravityTurnsBack) {
  expect_passages<2>(0.5, 4);
  expect_passages<3>(1.5, 6);
}

}  // namespace
}  // namespace sandglass::motion::surface_twin_test

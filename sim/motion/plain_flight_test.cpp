#include "sim/base/error.hpp"
#include "sim/motion/test_flight.hpp"
#include "sim/space/flight.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::motion::plain_flight_test {
namespace {

/// The slow twin: each axis by itself with the rules of flight.hpp.
template <int D>
Phase<D> fly(Phase<D> particle, const MotionParameters<D>& parameters, double dt) {
  for (int axis = 0; axis < D; ++axis) {
    const double length = box<D>()[axis], gravity = parameters.gravity[axis];
    double &x = particle.position[axis], &velocity = particle.velocity[axis];
    if (!parameters.walled[static_cast<std::size_t>(axis)]) {
      x = wrap(x + dt * (velocity + 0.5 * dt * gravity), length, 1 / length);
      velocity += dt * gravity;
      continue;
    }
    x = mirror(x, length);
    if (gravity == 0) fly_between_walls(x, velocity, dt, length);
    if (gravity != 0) fall_between_walls(x, velocity, gravity, dt, length);
  }
  return particle;
}

template <int D>
void expect_flight(const MotionParameters<D>& parameters, double dt) {
  auto store = scattered<D>(3, parameters.offsets ? 1.5 : 0);
  std::vector<Phase<D>> expected(store.size());
  for (std::size_t i = 0; i < store.size(); ++i)
    expected[store.ids()[i]] = fly(store.phases()[i], parameters, dt);
  store.begin_step();
  const auto motion = make_motion_stage<D>(parameters, box<D>());
  motion->advance(store, 0, 700, {dt});
  motion->advance(store, 700, store.size(), {dt});
  store.sort();
  for (std::uint32_t cell = 0; cell < store.grid().size(); ++cell)
    for (std::uint32_t i = store.offsets()[cell]; i < store.offsets()[cell + 1]; ++i) {
      const Phase<D>& is = store.phases()[i];
      ASSERT_EQ(store.grid().cell_of(is.position), cell);
      ASSERT_LT((is.position - expected[store.ids()[i]].position).norm(), 1e-13);
      ASSERT_LT((is.velocity - expected[store.ids()[i]].velocity).norm(), 1e-13);
    }
}

/// Every combination of walls, gravity along one axis or none, and offsets before the flight.
template <int D>
void expect_every_flight() {
  for (int code = 0; code < 1 << D; ++code)
    for (int pulled = -1; pulled < D; ++pulled)
      for (bool offsets : {false, true})
        for (double dt : {1e-3, 0.3, 5.0}) {
          MotionParameters<D> parameters;
          for (int axis = 0; axis < D; ++axis)
            parameters.walled[static_cast<std::size_t>(axis)] = code >> axis & 1;
          if (pulled >= 0) parameters.gravity[pulled] = -0.7;
          parameters.offsets = offsets;
          expect_flight<D>(parameters, dt);
        }
}

TEST(MotionStage, AgreesWithItsTwinAxisByAxis) {
  expect_every_flight<2>();
  expect_every_flight<3>();
}

/// A path without obstacle passes the plane as often as its unwrapped end says.
TEST(MotionStage, CountsCrossingsLikeArithmetic) {
  constexpr double kPlane = 0.4, kDt = 0.37;
  constexpr int kSteps = 50;
  auto store = scattered<2>(12);  // up to two periods a step
  double up = 0, down = 0;
  for (const Phase<2>& particle : store.phases()) {
    const double start = (particle.position[0] - kPlane) / box<2>()[0];
    const double end = start + particle.velocity[0] * kDt * kSteps / box<2>()[0];
    const double passages = std::floor(end) - std::floor(start);
    (passages > 0 ? up : down) += std::fabs(passages);
  }
  std::vector<Plane> planes{{0, kPlane, {-20, -5, 0, 5, 20}}};
  MotionParameters<2> parameters;
  parameters.planes = &planes;
  const auto motion = make_motion_stage<2>(parameters, box<2>());
  for (int step = 0; step < kSteps; ++step) {
    store.begin_step();
    motion->advance(store, 0, store.size(), {kDt});
    store.sort();
  }
  EXPECT_GT(up, 30'000);
  EXPECT_EQ(planes[0].up(), up);
  EXPECT_EQ(planes[0].down(), down);
  const auto histogram = planes[0].take_histogram();
  EXPECT_EQ(histogram[0] + histogram[1], down);
  EXPECT_EQ(histogram[2] + histogram[3], up);
}

/// Passages of a parabola through all images of a plane, by the roots of its equation; velocities at them.
std::vector<double> passages(double x, double v, double g, double length, double plane, double time) {
  std::vector<double> velocities;
  for (int image = -500; image <= 500; ++image) {
    const double square = v * v + 2 * g * (plane + image * length - x);
    for (const int sign : {-1, 1}) {
      const double t = (sign * std::sqrt(square) - v) / g;  // not a number: never there
      if (t > 0 && t <= time) velocities.push_back(v + g * t);
    }
  }
  return velocities;
}

TEST(MotionStage, CountsPassagesOfFallingParticles) {
  constexpr double kPlane = 0.4, kDt = 0.37, kGravity = -6;
  constexpr int kSteps = 20;
  auto store = scattered<2>(12, 0, 500);
  Plane expected(0, kPlane, {-60, -30, -5, 0, 5, 60});
  for (const Phase<2>& particle : store.phases())
    for (const double velocity :
         passages(particle.position[0], particle.velocity[0], kGravity, box<2>()[0], kPlane, kDt * kSteps))
      expected.count(velocity);
  std::vector<Plane> planes{{0, kPlane, expected.edges()}};
  MotionParameters<2> parameters;
  parameters.gravity[0] = kGravity;
  parameters.planes = &planes;
  const auto motion = make_motion_stage<2>(parameters, box<2>());
  for (int step = 0; step < kSteps; ++step) {
    store.begin_step();
    motion->advance(store, 0, store.size(), {kDt});
    store.sort();
  }
  EXPECT_GT(expected.up(), 300);
  EXPECT_EQ(planes[0].save(), expected.save());
}

/// Whatever a broken state brings, nothing is written outside the cells; the velocity shows it.
TEST(MotionStage, StopsAtWhatIsNotANumber) {
  for (const double wrong : {std::nan(""), HUGE_VAL})
    for (bool walled : {false, true})
      for (double gravity : {0.0, -1.0}) {
        auto store = scattered<3>(1);
        store.phases()[17].velocity[1] = wrong;
        MotionParameters<3> parameters;
        parameters.walled.fill(walled);
        parameters.gravity[2] = gravity;
        store.begin_step();
        EXPECT_THROW(make_motion_stage<3>(parameters, box<3>())->advance(store, 0, store.size(), {0.1}),
                     RunError);
      }
}

}  // namespace
}  // namespace sandglass::motion::plain_flight_test

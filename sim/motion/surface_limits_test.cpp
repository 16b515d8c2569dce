#include "sim/base/error.hpp"
#include "sim/motion/bounded_flight.hpp"
#include "sim/motion/test_flight.hpp"

#include <gtest/gtest.h>

// What holds whatever happens: particles stay outside of what is solid, steps end, the order of work cannot show.

namespace sandglass::motion::surface_limits_test {
namespace {

template <int D>
MotionParameters<D> thermal_room() {
  MotionParameters<D> parameters;
  parameters.walled[D - 1] = true;
  parameters.gravity[D - 1] = -1;
  parameters.obstacles = some_obstacles<D>({WallKind::thermal, {}, 1, 2});
  parameters.walls = {wall<D>(D - 1, false, {WallKind::thermal}),
                      wall<D>(D - 1, true, {WallKind::specular, {{0.5}}})};
  return parameters;
}

template <int D>
void expect_outside(std::span<const Phase<D>> particles, const MotionParameters<D>& parameters) {
  for (const Phase<D>& particle : particles) {
    for (const ObstaclePlace<D>& obstacle : parameters.obstacles)
      ASSERT_GE((particle.position - obstacle.centre).norm(), obstacle.radius);
    for (int axis = 0; axis < D; ++axis) {
      ASSERT_GE(particle.position[axis], 0);
      ASSERT_LE(particle.position[axis], box<D>()[axis]);
    }
  }
}

/// Long steps and short ones; before each, offsets throw the particles about.
template <int D>
void expect_always_outside(double beyond) {
  const auto parameters = thermal_room<D>();
  const auto motion = make_motion_stage<D>(parameters, box<D>());
  auto store = scattered<D>(3);
  Random random(StreamKey(4, Purpose::positions, 0, 0), 0);
  for (std::uint64_t step = 0; step < 40; ++step) {
    for (Phase<D>& particle : store.phases())
      particle.position += beyond * (2 * random_vector<D>(random) - Vector<D>::Ones());
    advance(*motion, store, {step % 2 ? 0.01 : 1.0, 0, wall_key(step)});
    expect_outside<D>(store.phases(), parameters);
    store.sort();
  }
}
TEST(SurfaceFlight, NeverEndsInsideWhatIsSolid) {
  for (const double beyond : {0.0, 0.2}) {
    expect_always_outside<2>(beyond);
    expect_always_outside<3>(beyond);
  }
}

/// What an offset has put into an obstacle or behind a wall starts from the nearest point of the surface.
template <int D>
void expect_put_back() {
  auto parameters = thermal_room<D>();
  parameters.gravity.setZero();
  const ObstaclePlace<D>& obstacle = parameters.obstacles[0];
  const Vector<D> normal = Vector<D>::Ones().normalized(), up = Vector<D>::Unit(D - 1);
  auto store = store_of<D>({{obstacle.centre, 2 * normal}, {0.9 * box<D>(), -up}});
  ASSERT_EQ(store.ids()[0], 0u);
  store.phases()[0].position += 0.1 * normal;
  store.phases()[1].position[D - 1] = box<D>()[D - 1] + 0.4;
  advance(*make_motion_stage<D>(parameters, box<D>()), store, {0.01, 0, wall_key(0)});
  const Vector<D> surface = obstacle.centre + obstacle.radius * normal;
  EXPECT_LT((store.phases()[0].position - (surface + 0.02 * normal)).norm(), 1e-14);
  EXPECT_NEAR(store.phases()[1].position[D - 1], box<D>()[D - 1] - 0.01, 1e-14);
}
/// Not by the last digit inside.
template <int D>
void expect_on_the_surface() {
  MotionParameters<D> parameters;
  parameters.obstacles = {some_obstacles<D>()[1]};
  const auto& [centre, radius, rule] = parameters.obstacles[0];
  auto store = scattered<D>(0);
  Random random(StreamKey(6, Purpose::positions, 0, 0), 0);
  for (Phase<D>& particle : store.phases())
    particle.position = centre + 0.5 * radius * (2 * random_vector<D>(random) - Vector<D>::Ones());
  advance(*make_motion_stage<D>(parameters, box<D>()), store, {0.01});
  for (const Phase<D>& particle : store.phases()) {
    ASSERT_GE((particle.position - centre).norm(), radius);
    ASSERT_LT((particle.position - centre).norm(), radius * (1 + 1e-14));
  }
}
TEST(SurfaceFlight, PutsBackWhatOffsetsHaveDisplaced) {
  expect_put_back<2>();
  expect_put_back<3>();
  expect_on_the_surface<2>();
  expect_on_the_surface<3>();
}

/// Infinitely many bounces in a finite time, on a floor and on top of an obstacle: it comes to rest there, and what it does
/// not fall in the rest of a step is less than a step's fall over kMostHits.
void expect_rest(const MotionParameters<2>& parameters, const Vector<2>& start, double floor) {
  constexpr double kStep = 0.1;
  const auto motion = make_motion_stage<2>(parameters, box<2>());
  auto store = store_of<2>({{start, Vector<2>::Zero()}});
  for (int step = 0; step < 400; ++step) {
    advance(*motion, store, {kStep});
    store.sort();
    ASSERT_GE(store.phases()[0].position[1], floor);
  }
  EXPECT_LT(std::fabs(store.phases()[0].velocity[1]), kStep / kMostHits);
  EXPECT_LT(store.phases()[0].position[1] - floor, 1e-5);
}
TEST(SurfaceFlight, BallComesToRest) {
  const WallRule lossy{WallKind::specular, {{0.8}}};
  MotionParameters<2> parameters;
  parameters.walled[1] = true;
  parameters.gravity[1] = -1;
  parameters.walls = {wall<2>(1, false, lossy)};
  expect_rest(parameters, {1, 0.5}, 0);
  parameters.obstacles = {{{1.0, 0.5}, 0.25, lossy}};
  expect_rest(parameters, {1, 1.2}, 0.75);
}

/// On a plate that shakes more weakly than gravity a ball that does not bounce rides along.
TEST(SurfaceFlight, BallRidesOnAPlate) {
  MotionParameters<2> parameters;
  parameters.walled[1] = true;
  parameters.gravity[1] = -1;
  WallPlace<2> plate = wall<2>(1, false, {WallKind::specular, {{0.3}}});
  plate.amplitude = 0.02, plate.frequency = 0.5;
  parameters.walls = {plate};
  const auto motion = make_motion_stage<2>(parameters, box<2>());
  auto store = store_of<2>({{{1, 0.1}, {0, 0}}});
  for (int step = 0; step < 1000; ++step) {
    const double time = 0.01 * (step + 1);
    advance(*motion, store, {0.01, 0.01 * step});
    store.sort();
    const double height = store.phases()[0].position[1] - plate.amplitude * std::sin(M_PI * time);
    ASSERT_GE(height, -1e-15);
    if (time > 3) {
      ASSERT_LT(height, 1e-3);
    }
  }
}

TEST(SurfaceFlight, StopsAtWhatIsNotANumber) {
  for (const double wrong : {std::nan(""), HUGE_VAL}) {
    auto store = scattered<3>(1);
    store.phases()[17].velocity[1] = wrong;
    EXPECT_THROW(advance(*make_motion_stage<3>(thermal_room<3>(), box<3>()), store, {0.1}), RunError);
    store.phases()[17].velocity[1] = 1e300;
    EXPECT_THROW(advance(*make_motion_stage<3>(thermal_room<3>(), box<3>()), store, {0.1}), RunError);
  }
}

/// Draws are named by step, old cell and old place: the order of the blocks cannot show, another step does.
TEST(SurfaceFlight, DrawsAreNamedByCellAndPlace) {
  const auto motion = make_motion_stage<3>(thermal_room<3>(), box<3>());
  const auto fly = [&](bool backwards, std::uint64_t step) {
    auto store = scattered<3>(3);
    const std::size_t middle = store.size() / 3;
    store.begin_step();
    if (backwards) motion->advance(store, middle, store.size(), {0.5, 0, wall_key(step)});
    motion->advance(store, 0, middle, {0.5, 0, wall_key(step)});
    if (!backwards) motion->advance(store, middle, store.size(), {0.5, 0, wall_key(step)});
    return std::vector<Phase<3>>(store.phases().begin(), store.phases().end());
  };
  const auto forth = fly(false, 1), back = fly(true, 1), later = fly(false, 2);
  int others = 0;
  for (std::size_t i = 0; i < forth.size(); ++i) {
    ASSERT_EQ(forth[i].velocity, back[i].velocity);
    ASSERT_EQ(forth[i].position, back[i].position);
    others += forth[i].velocity != later[i].velocity;
  }
  EXPECT_GT(others, 300);
}

/// A lattice of 102400 disks: who is not near one flies as if there were none, nobody ends inside.
TEST(SurfaceFlight, TakesHundredThousandObstacles) {
  constexpr int kEdge = 320;
  const Vector<2> spacing = box<2>() / kEdge;
  const double radius = 0.4 * spacing.minCoeff();
  MotionParameters<2> parameters;
  for (int i = 0; i < kEdge * kEdge; ++i)
    parameters.obstacles.push_back(
        {spacing.cwiseProduct(Vector<2>(i % kEdge + 0.5, i / kEdge + 0.5)), radius, {}});
  const auto motion = make_motion_stage<2>(parameters, box<2>());
  auto store = scattered<2>(1);
  const std::vector<Phase<2>> before(store.phases().begin(), store.phases().end());
  advance(*motion, store, {0.02});
  int hits = 0;
  for (std::size_t i = 0; i < store.size(); ++i) {
    const Phase<2>& particle = store.phases()[i];
    const Vector<2> cell = particle.position.cwiseQuotient(spacing).array().floor() + 0.5;
    ASSERT_GE((particle.position - spacing.cwiseProduct(cell)).norm(), radius);
    ASSERT_NEAR(particle.velocity.norm(), before[i].velocity.norm(), 1e-13);
    hits += particle.velocity != before[i].velocity;
  }
  EXPECT_GT(hits, 1000);
}

TEST(SurfaceFlight, RefusesSurroundingsThatMakeNoSense) {
  const auto refused = [](const MotionParameters<2>& parameters) {
    EXPECT_THROW(make_motion_stage<2>(parameters, box<2>()), InputError);
  };
  MotionParameters<2> parameters;
  parameters.walls = {wall<2>(1, false, {})};  // that axis is periodic
  refused(parameters);
  parameters.walls.clear();
  parameters.obstacles = {{{0.1, 0.5}, 0.2, {}}};  // through the edge
  refused(parameters);
  parameters.obstacles = {{{0.5, 0.5}, 0.2, {}}};
  EXPECT_NO_THROW(make_motion_stage<2>(parameters, box<2>()));
  std::vector<Plane> planes{{0, 0.5, {-1, 1}}};
  parameters.planes = &planes;
  EXPECT_NO_THROW(make_motion_stage<2>(parameters, box<2>()));
  parameters.walled[0] = true;  // at the ends of the plane's axis
  refused(parameters);
}

}  // namespace
}  // namespace sandglass::motion::surface_limits_test

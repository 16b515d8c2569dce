#include "sim/run/placement.hpp"

#include "sim/base/error.hpp"
#include "sim/run/test_scene.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace sandglass::placement_test {
namespace {

template <int D>
Scene scene_in(const Vector<D>& box, Positions positions, Side side = Side::periodic) {
  Scene scene = test_scene(D, 1, 1);
  scene.domain.size.assign(box.data(), box.data() + D);
  scene.domain.sides.assign(D, {side, side});
  scene.initial.positions = positions;
  return scene;
}

/// The slow twin of the packing's cells: every pair. Periodic images only where the sides are periodic.
template <int D>
double nearest(const std::vector<Phase<D>>& particles, const Vector<D>& box, bool periodic) {
  double smallest = HUGE_VAL;
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      Vector<D> gap = particles[i].position - particles[j].position;
      for (int axis = 0; periodic && axis < D; ++axis) gap[axis] = std::remainder(gap[axis], box[axis]);
      smallest = std::min(smallest, gap.norm());
    }
  return smallest;
}

template <int D>
void expect_in_box(const std::vector<Phase<D>>& particles, const Vector<D>& box) {
  for (const Phase<D>& particle : particles) {
    ASSERT_TRUE((particle.position.array() >= 0).all() && (particle.position.array() < box.array()).all());
    ASSERT_EQ(particle.velocity, Vector<D>(Vector<D>::Zero()));
  }
}

/// Boxes of two and fewer diameters along an axis too, where neighbour cells coincide.
template <int D>
void expect_no_overlap(const Vector<D>& box, std::uint64_t count) {
  for (Side side : {Side::periodic, Side::specular}) {
    const auto particles = place<D>(scene_in(box, Positions::random_without_overlap, side), count, {3, 0});
    ASSERT_EQ(particles.size(), count);
    expect_in_box(particles, box);
    EXPECT_GE(nearest(particles, box, side == Side::periodic), 1) << box.transpose();
  }
}

TEST(Placement, WithoutOverlapLeavesADiameter) {
  expect_no_overlap<2>({20.3, 17.9}, 150);
  expect_no_overlap<2>({2.1, 40}, 30);
  expect_no_overlap<2>({0.9, 40}, 10);
  expect_no_overlap<3>({7.3, 6.1, 5.9}, 90);
  expect_no_overlap<3>({1.4, 2.2, 30}, 25);
}

TEST(Placement, WithoutOverlapSaysWhenNoRoomIsLeft) {
  try {
    place<2>(scene_in<2>({5, 5}, Positions::random_without_overlap), 24, {1, 0});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no room for particle"), std::string::npos) << error.what();
  }
}

template <int D>
void expect_lattice(const Vector<D>& box, std::uint64_t count) {
  const auto particles = place<D>(scene_in(box, Positions::lattice), count, {1, 0});
  ASSERT_EQ(particles.size(), count);
  expect_in_box(particles, box);
  std::array<std::set<double>, D> lines;
  double sites = 1;
  for (std::size_t axis = 0; axis < D; ++axis) {
    for (const Phase<D>& particle : particles) lines[axis].insert(particle.position[static_cast<int>(axis)]);
    sites *= static_cast<double>(lines[axis].size());
    const double spacing = box[static_cast<int>(axis)] / static_cast<double>(lines[axis].size());
    EXPECT_NEAR(*lines[axis].begin(), spacing / 2, 1e-12 * spacing);
  }
  EXPECT_GE(sites, static_cast<double>(count));
  EXPECT_GT(nearest(particles, box, true), 0.5 * std::pow(box.prod() / static_cast<double>(count), 1.0 / D))
      << count;
}

TEST(Placement, LatticeFillsOddBoxes) {
  for (std::uint64_t count : {1u, 2u, 7u, 100u, 101u, 509u}) {
    expect_lattice<2>({10, 10}, count);
    expect_lattice<2>({7.3, 11.1}, count);
    expect_lattice<3>({5, 6, 7.7}, count);
  }
}

TEST(Placement, LatticeOfAPerfectNumberIsRegular) {
  EXPECT_NEAR(nearest<2>(place<2>(scene_in<2>({50, 50}, Positions::lattice), 2500, {1, 0}), {50, 50}, true),
              1, 1e-13);
  const auto particles = place<2>(scene_in<2>({8, 6}, Positions::lattice), 12, {1, 0});
  EXPECT_NEAR(nearest<2>(particles, {8, 6}, true), 2, 1e-14);
  EXPECT_EQ(particles[0].position, Vector<2>(1, 1));
  EXPECT_EQ(particles[11].position, Vector<2>(7, 5));
}

TEST(Placement, RandomIsUniformAndFollowsTheSeed) {
  constexpr std::uint64_t kCount = 40'000;
  const Scene scene = scene_in<2>({4, 8}, Positions::random);
  const auto particles = place<2>(scene, kCount, {1, 0});
  expect_in_box<2>(particles, {4, 8});
  std::array<double, 64> counts{};
  for (const Phase<2>& particle : particles)
    ++counts[static_cast<std::size_t>(2 * particle.position[0]) +
             8 * static_cast<std::size_t>(particle.position[1])];
  double chi = 0;
  for (double count : counts) chi += std::pow(count - kCount / 64.0, 2) / (kCount / 64.0);
  EXPECT_NEAR(chi, 63, 4.5 * std::sqrt(2 * 63));
  EXPECT_EQ(place<2>(scene, 5, {1, 0})[4].position, particles[4].position);
  EXPECT_NE(place<2>(scene, 5, {2, 0})[4].position, particles[4].position);
  EXPECT_NE(place<2>(scene, 5, {1, 1})[4].position, particles[4].position);
}

}  // namespace
}  // namespace sandglass::placement_test

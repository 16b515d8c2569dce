#include "sim/method/event_driven/candidates.hpp"

#include "sim/method/event_driven/contact_time.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::event_driven::candidates_test {
namespace {

/// Particles in `cells` random chains, the first of each.
std::vector<std::uint32_t> chain(std::vector<Particle<2>>& particles, std::uint32_t cells,
                                 std::mt19937_64& random) {
  std::vector<std::uint32_t> heads(cells, kNobody);
  for (std::uint32_t i = 0; i < particles.size(); ++i) {
    std::uint32_t& head = heads[random() % cells];
    particles[i].below = head;
    head = i;
  }
  return heads;
}

TEST(Candidates, GiveEachParticleOfEachChainOnce) {
  std::mt19937_64 random(1);
  Candidates near;
  for (std::uint32_t size : {0u, 1u, 3u, 4u, 5u, 8u, 17u, 300u, 2000u}) {
    std::vector<Particle<2>> particles(size + 1);
    near.clear();
    for (std::uint32_t head : chain(particles, 9, random)) near.add(head);
    std::vector<int> seen(particles.size());
    const std::uint32_t filler = size;
    while (near.more())
      for (std::uint32_t who : near.next(particles.data(), filler)) ++seen[who];
    for (std::uint32_t i = 0; i < size; ++i) EXPECT_EQ(seen[i], 1) << i << " of " << size;
    EXPECT_GE(seen[filler], 1);
    EXPECT_EQ(near.size(), size + 1);
  }
}

template <int D>
void check_columns() {
  std::vector<Particle<D>> particles(9);
  double number = 0;
  for (Particle<D>& particle : particles) {
    for (int axis = 0; axis < D; ++axis) {
      particle.position[axis] = ++number;
      particle.velocity[axis] = ++number;
    }
    particle.time = ++number;
  }
  const std::array<std::uint32_t, 4> which{7, 2, 2, 5};
  const Columns<D> columns(particles.data(), which);
  for (std::size_t k = 0; k < 4; ++k) {
    const Particle<D>& particle = particles[which[k]];
    for (int axis = 0; axis < D; ++axis) {
      EXPECT_EQ(columns.position(axis)[k], particle.position[axis]);
      EXPECT_EQ(columns.velocity(axis)[k], particle.velocity[axis]);
    }
    EXPECT_EQ(columns.time()[k], particle.time);
  }
}

TEST(Columns, HoldWhatTheBodiesHold) {
  check_columns<2>();
  check_columns<3>();
}

TEST(ContactTime, IsTheSameForOneAndForFour) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 1000; ++trial) {
    Quad along, gap, speed;
    for (int k = 0; k < 4; ++k) {
      along[k] = normal(random);
      gap[k] = normal(random);
      speed[k] = normal(random) * normal(random);
    }
    const Quad time = contact_time(along, gap, speed);
    for (int k = 0; k < 4; ++k) EXPECT_EQ(time[k], contact_time(along[k], gap[k], speed[k]));
  }
}

}  // namespace
}  // namespace sandglass::event_driven::candidates_test

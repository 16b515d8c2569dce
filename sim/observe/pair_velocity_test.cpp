#include "sim/observe/pair_velocity.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/test_view.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::pair_velocity_test {
namespace {

template <int D>
using Component = typename PairVelocity<D>::Component;

ObserverSpec shells(double low, double high, std::size_t bins) {
  ObserverSpec spec;
  spec.what = "pair-velocity";
  spec.range = {low, high};
  spec.bins = bins;
  return spec;
}

template <int D>
std::array<std::vector<double>, 2> measure(TestSystem<D>& system, const ObserverSpec& spec) {
  return {PairVelocity<D>(spec, Component<D>::parallel).measure(system.view()),
          PairVelocity<D>(spec, Component<D>::transverse).measure(system.view())};
}

/// Two disks along x, a third out of reach that takes the momentum of the centre of mass away.
TEST(PairVelocity, OfOnePair) {
  TestSystem<2> system;
  system.box = {20, 20};
  system.add_cell({{{1, 1}, {5, 2}}, {{2, 1}, {3, 4}}, {{10, 10}, {-8, -6}}});
  const auto [parallel, transverse] = measure<2>(system, shells(0.5, 2.5, 2));
  EXPECT_EQ(parallel, (std::vector<double>{5 * 3, 0}));
  EXPECT_EQ(transverse, (std::vector<double>{2 * 4, 0}));
}

/// A rigid rotation about the middle of a pair, across the seam: parallel 0, transverse -w^2 r^2 / 4 over the two
/// directions that a sphere has, one of them empty.
TEST(PairVelocity, OfARotatingPair) {
  TestSystem<3> system;
  system.box = {10, 10, 10};
  system.add_cell({{{9.5, 5, 5}, {0, 3, 0}}, {{0.5, 5, 5}, {0, -3, 0}}});
  const auto [parallel, transverse] = measure<3>(system, shells(0, 2, 1));
  EXPECT_EQ(parallel[0], 0);
  EXPECT_EQ(transverse[0], -4.5);
}

/// Slow twin: every pair with every image of the second partner, projected onto unit vectors.
template <int D>
void expect_twin(const Vector<D>& box, std::size_t count, const ObserverSpec& spec, std::uint64_t seed) {
  auto system = random_system<D>(box, count, seed);
  Vector<D> mean = Vector<D>::Zero();
  for (const Phase<D>& particle : system.particles) mean += particle.velocity / static_cast<double>(count);
  const auto edges = bin_edges(spec);
  std::vector<double> parallel(spec.bins), transverse(spec.bins), pairs(spec.bins);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (int image = 0; image < (D == 2 ? 9 : 27); ++image) {
        const Vector<3> shift(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
        const Vector<D> apart =
            system.particles[i].position - system.particles[j].position + box.cwiseProduct(shift.head<D>());
        const Vector<D> along = apart.normalized();
        const Vector<D> one = system.particles[i].velocity - mean, two = system.particles[j].velocity - mean;
        const Vector<D> across_1 = one - one.dot(along) * along, across_2 = two - two.dot(along) * along;
        for (std::size_t bin = 0; bin < spec.bins; ++bin) {
          if (apart.norm() < edges[bin] || apart.norm() >= edges[bin + 1]) continue;
          parallel[bin] += one.dot(along) * two.dot(along);
          transverse[bin] += across_1.dot(across_2) / (D - 1);
          ++pairs[bin];
        }
      }
  const auto fast = measure<D>(system, spec);
  for (std::size_t bin = 0; bin < spec.bins; ++bin) {
    EXPECT_NEAR(fast[0][bin], parallel[bin] / std::max(pairs[bin], 1.0), 1e-12) << bin;
    EXPECT_NEAR(fast[1][bin], transverse[bin] / std::max(pairs[bin], 1.0), 1e-12) << bin;
  }
}

TEST(PairVelocity, LooksAtEveryPairOnce) {
  std::uint64_t seed = 1;
  for (double high : {0.3, 0.9, 1.3, 2.0}) {
    expect_twin<2>({4, 7}, 100, shells(0, high, 5), ++seed);
    expect_twin<3>({4, 5, 11}, 100, shells(0.1, high, 5), ++seed);
  }
}

/// Independent velocities: -<C^2> / D (N - 1) on average, which 2000 particles show against the scatter of one pair,
/// <C_x^2> = 1/3 each, over the root of their number.
TEST(PairVelocity, OfIndependentParticlesVanishes) {
  auto system = random_system<3>(Vector<3>(8, 8, 8), 2000, 5);
  const auto spec = shells(0, 4, 4);
  const auto edges = bin_edges(spec);
  const auto values = measure<3>(system, spec);
  for (const auto& component : values)
    for (std::size_t bin = 0; bin < spec.bins; ++bin) {
      const double shell =
          4 * M_PI / 3 *
          (edges[bin + 1] * edges[bin + 1] * edges[bin + 1] - edges[bin] * edges[bin] * edges[bin]);
      const double pairs = 2000.0 * 1999 / 2 * shell / 512;
      EXPECT_NEAR(component[bin], -1 / (3 * 1999.0), 4 / 3.0 / std::sqrt(pairs)) << bin;
    }
}

/// All of one stream and nothing else: no correlation beyond it.
TEST(PairVelocity, IsRelativeToTheCentreOfMass) {
  auto system = random_system<2>({4, 4}, 50, 7);
  const auto before = measure<2>(system, shells(0, 2, 3));
  for (Phase<2>& particle : system.particles) particle.velocity += Vector<2>(3, -4);
  const auto after = measure<2>(system, shells(0, 2, 3));
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t bin = 0; bin < 3; ++bin) EXPECT_NEAR(before[k][bin], after[k][bin], 1e-13);
}

TEST(PairVelocity, RefusesWhatItCannotCount) {
  EXPECT_THROW(PairVelocity<2>(shells(1, 1, 2), Component<2>::parallel), InputError);
  auto system = random_system<2>({4, 9}, 5, 1);
  EXPECT_NO_THROW(PairVelocity<2>(shells(0, 2, 2), Component<2>::parallel).start(system.view()));
  EXPECT_THROW(PairVelocity<2>(shells(0, 2.01, 2), Component<2>::parallel).start(system.view()), InputError);
  system.weights.assign(5, 2);
  EXPECT_THROW(PairVelocity<2>(shells(0, 2, 2), Component<2>::parallel).start(system.view()), InputError);
}

}  // namespace
}  // namespace sandglass::pair_velocity_test

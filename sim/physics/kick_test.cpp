#include "sim/base/statistics.hpp"
#include "sim/physics/collision.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

// smooth_kick and its slow twin, contact_normal with SmoothInelastic, through the same tests. Statistical bounds are
// 4.5 standard errors.

namespace sandglass::kick_test {
namespace {

constexpr int kDraws = 300'000;
constexpr double kRestitution = 0.7;

template <int D>
Vector<D> relative_velocity() {
  return D == 2 ? Vector<D>(Vector<3>(0.6, -1.1, 0).head<D>())
                : Vector<D>(Vector<3>(0.6, -1.1, 0.4).head<D>());
}

template <int D>
Vector<D> fast(Random& random) {
  const Vector<D> relative = relative_velocity<D>();
  return smooth_kick(relative, relative.squaredNorm(), kRestitution, random);
}

template <int D>
Vector<D> slow(Random& random) {
  Vector<D> one = relative_velocity<D>(), two = Vector<D>::Zero();
  SmoothInelastic{kRestitution}(one, two, contact_normal(one, 1 / one.norm(), uniform_impact<D>(random)));
  return -two;
}

template <int D, class Draw>
std::vector<Vector<D>> kicks(Draw draw) {
  Random random(StreamKey(3, Purpose::collisions, 0, 0), 0);
  std::vector<Vector<D>> list(kDraws);
  for (Vector<D>& kick : list) kick = draw(random);
  return list;
}

template <int D, class Function>
void expect_mean(const std::vector<Vector<D>>& list, Function function, double expected) {
  std::vector<double> samples;
  for (const Vector<D>& kick : list) samples.push_back(function(kick));
  const Mean mean = mean_of_independent(samples);
  EXPECT_NEAR(mean.value, expected, 4.5 * mean.standard_error);
}

/// <cos^2> of the angle between -c and the normal: 2/3 on disks, 1/2 on spheres. With it, and n n split along c and across:
/// <kick> = -(1 + r)/2 <cos^2> c, <kick_i kick_j> from <cos^4> = 8/15 (1/3 on spheres).
template <int D>
void expect_moments(const std::vector<Vector<D>>& list) {
  const Vector<D> c = relative_velocity<D>(), unit = c.normalized();
  const double square = D == 2 ? 2.0 / 3 : 1.0 / 2, fourth = D == 2 ? 8.0 / 15 : 1.0 / 3;
  const double half = 0.5 * (1 + kRestitution), across = (square - fourth) / (D - 1);
  for (int i = 0; i < D; ++i) {
    expect_mean<D>(
        list, [=](const Vector<D>& kick) { return kick[i]; }, -half * square * c[i]);
    for (int j = 0; j <= i; ++j) {
      const double tensor = across * (i == j) + (fourth - across) * unit[i] * unit[j];
      expect_mean<D>(
          list, [=](const Vector<D>& kick) { return kick[i] * kick[j]; },
          half * half * c.squaredNorm() * tensor);
    }
  }
  expect_mean<D>(
      list, [=](const Vector<D>& kick) { return -c.dot(kick) - kick.squaredNorm(); },
      0.25 * (1 - kRestitution * kRestitution) * c.squaredNorm() * square);
}

TEST(SmoothKick, HasTheMomentsOfItsTwin) {
  expect_moments<2>(kicks<2>(fast<2>));
  expect_moments<2>(kicks<2>(slow<2>));
  expect_moments<3>(kicks<3>(fast<3>));
  expect_moments<3>(kicks<3>(slow<3>));
}

/// |kick| = (1 + r)/2 |c| cos. The impact parameter is uniform: sin is uniform on disks, sin^2 on spheres.
template <int D>
void expect_cosine_distribution(const std::vector<Vector<D>>& list) {
  constexpr std::size_t kBins = 40;
  std::array<double, kBins> count{};
  const double largest = 0.5 * (1 + kRestitution) * relative_velocity<D>().norm();
  for (const Vector<D>& kick : list) {
    const double square = std::max(0.0, 1 - kick.squaredNorm() / (largest * largest));
    const double uniform = D == 2 ? std::sqrt(square) : square;
    ++count[std::min(kBins - 1, static_cast<std::size_t>(uniform * kBins))];
  }
  double chi = 0;
  for (double n : count) chi += std::pow(n - kDraws / static_cast<double>(kBins), 2) * kBins / kDraws;
  // 39 degrees of freedom: mean 39, standard deviation 8.8.
  EXPECT_LT(chi, 39 + 5 * 8.8);
  EXPECT_GT(chi, 39 - 4 * 8.8);
}

TEST(SmoothKick, HasTheCosinesOfItsTwin) {
  expect_cosine_distribution<2>(kicks<2>(fast<2>));
  expect_cosine_distribution<2>(kicks<2>(slow<2>));
  expect_cosine_distribution<3>(kicks<3>(fast<3>));
  expect_cosine_distribution<3>(kicks<3>(slow<3>));
}

/// Every single kick obeys the collision rule, with its own direction as the normal.
template <int D>
void expect_rule(const std::vector<Vector<D>>& list) {
  const Vector<D> c = relative_velocity<D>();
  for (const Vector<D>& kick : list)
    ASSERT_NEAR(kick.squaredNorm(), -0.5 * (1 + kRestitution) * c.dot(kick), 1e-14);
}

TEST(SmoothKick, ObeysTheCollisionRule) {
  expect_rule<2>(kicks<2>(fast<2>));
  expect_rule<3>(kicks<3>(fast<3>));
}

}  // namespace
}  // namespace sandglass::kick_test

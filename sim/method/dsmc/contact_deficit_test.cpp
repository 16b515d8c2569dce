#include "sim/method/dsmc/local_factor.hpp"
#include "sim/method/dsmc/pair_deficit.hpp"

#include <cmath>

#include <gtest/gtest.h>

// The pairs that partners at contact miss: the fit against the integral of linear theory, docs/theory.md.

namespace sandglass::dsmc::contact_deficit_test {
namespace {

/// Transforms of the circle or sphere of radius one, of the ball over its volume, and of a partner's place in its cell along
/// one axis.
template <int D>
double shell(double k) {
  return D == 2 ? std::cyl_bessel_j(0.0, k) : std::sin(k) / k;
}
template <int D>
double ball(double k) {
  return D == 2 ? 2 * std::cyl_bessel_j(1.0, k) / k : 3 * (std::sin(k) - k * std::cos(k)) / (k * k * k);
}
double place(double k, double edge) { return std::pow(std::sin(0.5 * k * edge) / (0.5 * k * edge), 2); }

/// Missing part of the pairs times particles per cell: L^D a int shell s^2 ball/(1 + a s ball) d^Dk/(2 pi)^D.
template <int D>
double integral(double slope, double edge) {
  constexpr int kPoints = D == 2 ? 120 : 48;
  constexpr double kLargest = 16, kStep = kLargest / kPoints;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i)
    for (int j = 0; j < kPoints; ++j)
      for (int l = 0; l < (D == 3 ? kPoints : 1); ++l) {
        const double x = (i + 0.5) * kStep, y = (j + 0.5) * kStep, z = D == 3 ? (l + 0.5) * kStep : 0;
        const double k = std::sqrt(x * x + y * y + z * z);
        const double s = place(x, edge) * place(y, edge) * (D == 3 ? place(z, edge) : 1);
        sum += shell<D>(k) * s * s * ball<D>(k) / (1 + slope * s * ball<D>(k));
      }
  return slope * std::pow(edge * kStep / M_PI, D) * sum;
}

/// Without a contact factor the collisional pressure rises by 2^D nu, and the window has no part.
template <int D>
void expect_fit() {
  constexpr double kPerCell = 50;
  for (const double slope : {0.2, 1.0, 6.0})
    for (const double edge : {1.0, 1.5, 2.5, 4.0}) {
      Parameters parameters;
      parameters.partners = Partners::contact;
      const double density = slope / std::exp2(D) / particle_volume(D, 1);
      parameters.weight = density * std::pow(edge, D) / kPerCell;
      const double fit = kPerCell * expected_pair_deficit(D, parameters, density, kPerCell);
      EXPECT_NEAR(fit / integral<D>(slope, edge), 1, 0.12) << D << "D, " << slope << ", cells of " << edge;
    }
}

TEST(ContactDeficit, IsTheIntegralOfLinearTheory) {
  expect_fit<2>();
  expect_fit<3>();
}

TEST(ContactDeficit, SetsHowManyParticlesACellHolds) {
  Parameters parameters;
  parameters.partners = Partners::contact;
  parameters.factor.formula = carnahan_starling;
  const double density = 0.25 / particle_volume(3, 1);
  EXPECT_GT(default_particles_per_cell(3, parameters, density), 30);
  parameters.partners = Partners::cell;
  EXPECT_EQ(default_particles_per_cell(3, parameters, density), 10);
}

}  // namespace
}  // namespace sandglass::dsmc::contact_deficit_test

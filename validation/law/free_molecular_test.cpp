#include "validation/law/free_molecular.hpp"

#include "validation/law/quadrature.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

// Independent of the closed forms: each point of a surface faces a drifting Maxwellian, whose flux of particles
// and of momentum is integrated over velocities first and over the surface then.

namespace sandglass::law::free_molecular_test {
namespace {

using quadrature::integral;
using std::numbers::pi;

constexpr double kMass = 1.3, kTemperature = 0.7, kDensity = 2.1, kRadius = 0.6, kSurface = 1.9;

double maxwellian(double velocity, double mean) {
  const double c = kMass / (2 * kTemperature);
  return std::sqrt(c / pi) * std::exp(-c * (velocity - mean) * (velocity - mean));
}

/// Integral of v^power f(v) over the velocities towards a surface that the stream approaches at `normal`.
double towards(double normal, int power) {
  const double spread = 9 * std::sqrt(kTemperature / kMass);
  const double low = std::max(0.0, normal - spread), high = std::max(0.0, normal) + spread;
  return integral([=](double v) { return std::pow(v, power) * maxwellian(v, normal); }, low, high);
}

/// Force per area along the stream at a point whose normal makes `angle` with the way that the stream comes
/// from, for a surface of each kind.
double on_surface(double angle, const StreamPastObstacle& stream) {
  const double along = std::cos(angle), across = std::sin(angle);
  const double rate = kDensity * towards(stream.velocity * along, 1);
  const double normal = kMass * kDensity * towards(stream.velocity * along, 2);
  const double shear = kMass * rate * stream.velocity * across;
  const double arriving = normal * along + shear * across;
  const double leaving = rate * std::sqrt(pi * kMass * stream.surface_temperature / 2) * along;
  return stream.accommodation * (arriving + leaving) + stream.reversal * 2 * arriving +
         (1 - stream.accommodation - stream.reversal) * 2 * normal * along;
}

double drag_by_quadrature(const StreamPastObstacle& stream) {
  return integral(
      [&](double angle) {
        const double ring =
            stream.dimension == 2 ? 2 * kRadius : 2 * pi * kRadius * kRadius * std::sin(angle);
        return ring * on_surface(angle, stream);
      },
      0, pi);
}

StreamPastObstacle stream(int dimension, double s, double accommodation, double reversal) {
  return {dimension, kDensity, kMass,         kTemperature, s * std::sqrt(2 * kTemperature / kMass),
          kRadius,   kSurface, accommodation, reversal};
}

TEST(FreeMolecularDrag, IsTheIntegralOverTheSurface) {
  for (const int dimension : {2, 3})
    for (const double s : {0.02, 0.049, 0.051, 0.5, 1.0, 3.0})
      for (const auto& [thermal, back] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.3, 0.2}}) {
        const StreamPastObstacle flow = stream(dimension, s, thermal, back);
        EXPECT_NEAR(free_molecular_drag(flow) / drag_by_quadrature(flow), 1, 1e-7)
            << dimension << " " << s << " " << thermal << " " << back;
      }
}

TEST(FreeMolecularDrag, SlowStreamDragsInProportion) {
  const double thermal = std::sqrt(2 * pi * kMass * kTemperature);
  const StreamPastObstacle sphere = stream(3, 1e-9, 0, 0);  // Epstein 1924: 8/3 sqrt(2 pi m T) n R^2 U
  EXPECT_NEAR(
      free_molecular_drag(sphere) / (8.0 / 3 * thermal * kDensity * kRadius * kRadius * sphere.velocity), 1,
      1e-12);
  const StreamPastObstacle disk = stream(2, 1e-9, 0, 0);  // 2 sqrt(2 pi m T) n R U
  EXPECT_NEAR(free_molecular_drag(disk) / (2 * thermal * kDensity * kRadius * disk.velocity), 1, 1e-12);
  EXPECT_EQ(free_molecular_drag(stream(3, 0, 1, 0)), 0);
}

TEST(FreeMolecularDrag, FastStreamIsABeam) {  // a mirror: 4/3 and 1 times rho U^2 times half the front
  StreamPastObstacle disk = stream(2, 1000, 0, 0), sphere = stream(3, 1000, 0, 0);
  const double pressure = kMass * kDensity * disk.velocity * disk.velocity;
  EXPECT_NEAR(free_molecular_drag(disk) / (pressure * 4.0 / 3 * 2 * kRadius), 1, 1e-5);
  EXPECT_NEAR(free_molecular_drag(sphere) / (pressure * pi * kRadius * kRadius), 1, 1e-5);
  disk.velocity = -disk.velocity;
  EXPECT_LT(free_molecular_drag(disk), 0);
}

/// Energy and number of the stream that a thermal wall sends, by its velocities: flux density over speed.
struct HalfGas {
  double number, normal_square;
};

HalfGas sent_by(double wall) {
  const double root = std::sqrt(wall);  // mass 1; unit flux
  const auto density = [=](double v) { return std::exp(-v * v / (2 * wall)) / wall; };
  return {integral(density, 0, 10 * root),
          integral([=](double v) { return v * v * density(v); }, 0, 10 * root)};
}

TEST(KnudsenTemperature, IsThatOfTwoStreamsOfEqualFlux) {
  const double cold = 0.4, hot = 3.1;
  const HalfGas up = sent_by(cold), down = sent_by(hot);
  const double number = up.number + down.number;
  EXPECT_NEAR(knudsen_temperature(cold, hot), (up.normal_square + down.normal_square) / number, 1e-9);
  EXPECT_NEAR(knudsen_temperature(cold, hot), (up.number * cold + down.number * hot) / number, 1e-9);
}

TEST(BarometricFraction, IsTheShareOfTheBoltzmannFactor) {
  const Column column{1.3, 0.7, 2.0, 1.6};
  const auto factor = [](double z) { return std::exp(-1.3 * 2.0 * z / 0.7); };
  const double all = integral(factor, 0, column.height);
  for (const double z : {0.01, 0.4, 1.2, 1.6})
    EXPECT_NEAR(barometric_fraction(column, z), integral(factor, 0, z) / all, 1e-9) << z;
  EXPECT_EQ(barometric_fraction(column, -1), 0);
  EXPECT_EQ(barometric_fraction(column, 2), 1);
}

TEST(BarometricFraction, WithoutGravityIsEven) {
  EXPECT_DOUBLE_EQ(barometric_fraction({1, 1, 0, 2}, 0.5), 0.25);
  EXPECT_NEAR(barometric_fraction({1, 1, 1e-12, 2}, 0.5), 0.25, 1e-12);
}

}  // namespace
}  // namespace sandglass::law::free_molecular_test

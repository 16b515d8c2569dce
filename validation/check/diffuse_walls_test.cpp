#include "validation/law/diffuse_walls.hpp"

#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

// Records of a gas between two diffuse walls made by hand: right ones agree, wrong ones are off by what is wrong.

namespace sandglass::diffuse_walls_test {
namespace {

using namespace synthetic;

constexpr double kLength = 0.28284271247461906, kHeight = 10, kSliding = 0.8, kCold = 0.8, kHot = 1.2;

law::Gap gap(bool heat) {
  const double fraction = 1000 * std::numbers::pi / 4 * 1e-6 / (kLength * kHeight);
  law::Gap all{{2, 0.001, 1, 1, fraction, 1}, kHeight, 1, 1, heat ? 0 : kSliding};
  if (heat) all.low_temperature = kCold, all.high_temperature = kHot;
  return all;
}

std::string scene(bool heat) {
  const char* walls =
      heat ? "[[wall]]\nside = \"y-low\"\nrule = \"thermal\"\ntemperature = 0.8\n"
             "[[wall]]\nside = \"y-high\"\nrule = \"thermal\"\ntemperature = 1.2\n"
           : "[[wall]]\nside = \"y-low\"\nrule = \"thermal\"\ntemperature = 1.0\nvelocity = [-0.4, 0.0]\n"
             "[[wall]]\nside = \"y-high\"\nrule = \"thermal\"\ntemperature = 1.0\nvelocity = [0.4, 0.0]\n";
  return std::string(
             "[run]\nduration = { time = 300.0 }\n[domain]\ndimension = 2\n"
             "size = [0.28284271247461906, 10.0]\nsides = { y = \"specular\" }\n"
             "[[species]]\ncount = 1000\ndiameter = 0.001\n"
             "[method]\npreset = \"dsmc\"\ncells = [1, 40]\ntime-step = 0.1\n") +
         walls;
}

/// Slope of T^(3/2), and what passes between the walls.
struct Flow {
  double temperature = 0, stress = 0, heat = 0;
};

Record record_of_flow(bool heat, const Flow& flow) {
  Record record;
  record.scene = scene(heat);
  record.replicas.resize(8);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    record.replicas[replica].series.reserve(3);
    Series& fields = add_series(record, replica, "fields", {});
    fields.quantity.shape = {1, 20, 4};
    Series& force = add_series(record, replica, "wall-force", {"y-low-x", "y-low-y", "y-high-x", "y-high-y"});
    Series& flux = add_series(record, replica, "energy-flux", {});
    flux.quantity.shape = {1, 20, 2};
    std::vector<double> bins, fluxes;
    for (int bin = 0; bin < 20; ++bin) {
      const double y = (bin + 0.5) * kHeight / 20 - kHeight / 2;
      bins.insert(bins.end(),
                  {1000 / (kLength * kHeight), 0, 0, std::pow(1 + flow.temperature * y, 2 / 3.0)});
      fluxes.insert(fluxes.end(), {0, -flow.heat});
    }
    const double before = 1e3;  // what comes before `settle-time` does not count
    add_sample(fields, 1, std::vector<double>(80, before));
    add_sample(force, 1, {before, 0, 0, 0});
    add_sample(flux, 1, std::vector<double>(40, before));
    for (const double time : {100.0, 200.0, 300.0}) {
      add_sample(fields, time, bins);
      add_sample(force, time, {flow.stress * kLength, 0, -flow.stress * kLength, 0});
      add_sample(flux, time, fluxes);
    }
  }
  return record;
}

Evidence evidence(const std::string& check, bool heat, const Flow& flow) {
  return run_check(find_check(check), record_of_flow(heat, flow), {{{"settle-time", 100}}, 0, 0, ""});
}

double middle(const law::EndCorrection& correction) { return (correction.least + correction.most) / 2; }

void expect_value(const Evidence& evidence, double value) {
  EXPECT_NEAR(evidence.value, value, 1e-9);
  EXPECT_LT(evidence.budget.systematic, 0.12);
}

TEST(DiffuseWalls, FluxesAreHeldAgainstTheInterpolation) {
  const law::Gap sliding = gap(false), heated = gap(true);
  const double stress =
      law::interpolated_flux(law::free_molecular_shear_stress(sliding), law::continuum_shear_stress(sliding),
                             middle(law::slip_correction()));
  const double heat =
      law::interpolated_flux(law::free_molecular_heat_flux(heated), law::continuum_heat_flux(heated),
                             middle(law::jump_correction()));
  for (const double factor : {1.0, 0.8}) {
    expect_value(evidence("wall-shear-stress", false, {.stress = factor * stress}), factor);
    expect_value(evidence("wall-heat-flux", true, {.heat = factor * heat}), factor);
  }
}

/// The line of the middle reaches the wall's own value a length behind the wall.
TEST(DiffuseWalls, TheJumpIsALengthBehindTheWall) {
  const double jump = law::jump_length_maxwell(gap(true).gas);
  const double step = std::pow(kHot, 1.5) - std::pow(kCold, 1.5);
  for (const double factor : {1.08, 3.0}) {
    const Evidence jumping =
        evidence("jump-length", true, {.temperature = step / (kHeight + 2 * factor * jump)});
    EXPECT_NEAR(jumping.value, factor, 1e-9);
    EXPECT_EQ(std::abs(jumping.value - jumping.expected) < jumping.budget.systematic, factor < 2);
  }
}

}  // namespace
}  // namespace sandglass::diffuse_walls_test

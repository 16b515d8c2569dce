#include "validation/law/catalogue.hpp"

#include "validation/law/enskog.hpp"
#include "validation/law/flux.hpp"
#include "validation/law/haff.hpp"
#include "validation/law/moments.hpp"
#include "validation/law/shear_modes.hpp"
#include "validation/law/sonine.hpp"
#include "validation/law/state.hpp"
#include "validation/law/transport.hpp"

#include <gtest/gtest.h>

namespace sandglass::law::catalogue_test {
namespace {

// Every number differs from every other and from 1, so that a law wired to the wrong function or argument
// shows.
const Gas kGas{
    .dimension = 3, .diameter = 0.7, .mass = 1.3, .temperature = 2.1, .fraction = 0.2, .restitution = 0.6};
const Stream kStream{.number_density = 0.9, .mass = 1.3, .temperature = 2.1, .velocity = -0.4};

const Arguments kKnown = {{"dimension", 3},
                          {"diameter", 0.7},
                          {"mass", 1.3},
                          {"temperature", 2.1},
                          {"volume-fraction", 0.2},
                          {"restitution", 0.6},
                          {"number-density", 0.9},
                          {"stream-velocity", -0.4},
                          {"time", 1.7},
                          {"time-scale", 2.3},
                          {"initial-rate", 1.9},
                          {"collisions", 3.1},
                          {"order", 6},
                          {"sonine-a2", 0.05}};

double value(const std::string& name, double velocity = 0) {
  const Law& law = find_law(name);
  Arguments arguments;
  for (const Parameter& parameter : law.parameters) {
    if (parameter.name == "velocity") arguments["velocity"] = velocity;
    if (const auto known = kKnown.find(parameter.name); known != kKnown.end()) arguments.insert(*known);
  }
  return evaluate(law, arguments);
}

TEST(Catalogue, GasLawsCallTheFunctionOfTheirName) {
  const std::map<std::string, double (*)(const Gas&)> functions = {
      {"enskog-collision-rate", collision_rate},
      {"mean-speed", mean_speed},
      {"mean-free-path", mean_free_path},
      {"compressibility-factor", compressibility_factor},
      {"pressure", pressure},
      {"kinetic-pressure", kinetic_pressure},
      {"collisional-pressure", collisional_pressure},
      {"cooling-rate", cooling_rate},
      {"cooling-rate-sonine", cooling_rate_sonine},
      {"haff-time-scale", haff_time_scale},
      {"haff-time-scale-sonine", haff_time_scale_sonine},
      {"marginal-wave-length", marginal_wave_length},
      {"sound-speed", sound_speed},
      {"enskog-bulk-viscosity", enskog_bulk_viscosity}};
  for (const auto& [name, function] : functions) EXPECT_DOUBLE_EQ(value(name), function(kGas)) << name;
}

TEST(Catalogue, CoolingLawsTakeTheirArguments) {
  EXPECT_DOUBLE_EQ(value("haff-energy-ratio"), haff_energy_ratio(1.7, 2.3));
  EXPECT_DOUBLE_EQ(value("haff-collisions"), haff_collisions(1.9, 1.7, 2.3));
  EXPECT_DOUBLE_EQ(value("haff-energy-ratio-of-collisions"), haff_energy_ratio_of_collisions(3, 0.6, 3.1));
  EXPECT_DOUBLE_EQ(value("sonine-a2"), sonine_a2(3, 0.6));
  EXPECT_DOUBLE_EQ(value("sonine-a2-relinearised"), sonine_a2_relinearised(3, 0.6));
  EXPECT_DOUBLE_EQ(value("sonine-a2-third-order"), sonine_coefficients<3>(3, 0.6)[0]);
  EXPECT_DOUBLE_EQ(value("sonine-sixth-moment"), sonine_sixth_moment(sonine_coefficients<3>(3, 0.6)));
  EXPECT_DOUBLE_EQ(value("collision-rate-sonine"),
                   collision_rate(kGas) * sonine_collision_factor(sonine_a2(3, 0.6)));
}

TEST(Catalogue, MomentLawsTakeTheirArguments) {
  const double variance = 2.1 / 1.3;
  const double factor = sonine_moment_factor(6, 0.05);
  EXPECT_NEAR(value("maxwell-component-moment") / maxwell_component_moment(6, variance), 1, 1e-14);
  EXPECT_NEAR(value("maxwell-speed-moment") / maxwell_speed_moment(3, 6, variance), 1, 1e-14);
  EXPECT_NEAR(value("sonine-component-moment") / maxwell_component_moment(6, variance), factor, 1e-14);
  EXPECT_NEAR(value("sonine-speed-moment") / maxwell_speed_moment(3, 6, variance), factor, 1e-14);
}

TEST(Catalogue, FluxLawsTakeTheirArguments) {
  EXPECT_DOUBLE_EQ(value("flux-forward"), flux_forward(kStream));
  EXPECT_DOUBLE_EQ(value("flux-backward"), flux_backward(kStream));
  EXPECT_DOUBLE_EQ(value("flux-net"), flux_net(kStream));
  EXPECT_DOUBLE_EQ(value("flux-mean-forward"), flux_mean_forward(kStream));
  EXPECT_DOUBLE_EQ(value("flux-mean-backward"), flux_mean_backward(kStream));
  EXPECT_DOUBLE_EQ(value("flux-density-forward", 0.8), flux_density_forward(kStream, 0.8));
  EXPECT_DOUBLE_EQ(value("flux-density-backward", -0.8), flux_density_backward(kStream, -0.8));
  EXPECT_DOUBLE_EQ(value("flux-cumulative-forward", 0.8), flux_cumulative_forward(kStream, 0.8));
  EXPECT_DOUBLE_EQ(value("flux-cumulative-backward", -0.8), flux_cumulative_backward(kStream, -0.8));
}

TEST(Catalogue, ViscosityLawsTakeTheirOrder) {
  using enum SonineOrder;
  EXPECT_DOUBLE_EQ(value("boltzmann-shear-viscosity"), boltzmann_shear_viscosity(kGas, first));
  EXPECT_DOUBLE_EQ(value("boltzmann-shear-viscosity-converged"), boltzmann_shear_viscosity(kGas, converged));
  EXPECT_DOUBLE_EQ(value("enskog-shear-viscosity"), enskog_shear_viscosity(kGas, first));
  EXPECT_DOUBLE_EQ(value("enskog-shear-viscosity-converged"), enskog_shear_viscosity(kGas, converged));
  EXPECT_DOUBLE_EQ(value("kinematic-viscosity"), enskog_kinematic_viscosity(kGas, first));
  EXPECT_DOUBLE_EQ(value("kinematic-viscosity-converged"), enskog_kinematic_viscosity(kGas, converged));
}

}  // namespace
}  // namespace sandglass::law::catalogue_test

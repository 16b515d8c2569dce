#include "validation/law/falling.hpp"
#include "validation/law/fluctuation.hpp"
#include "validation/law/heap.hpp"
#include "validation/law/impact.hpp"
#include "validation/law/law.hpp"
#include "validation/law/uniform_shear.hpp"
#include "validation/law/vibrated_bed.hpp"

#include <gtest/gtest.h>

namespace sandglass::law::catalogue_flows_test {
namespace {

// Every number differs from every other and from 1, so that a law wired to the wrong function or argument shows.
const Arguments kKnown = {{"dimension", 3},
                          {"diameter", 0.7},
                          {"mass", 1.3},
                          {"temperature", 2.1},
                          {"volume-fraction", 0.2},
                          {"restitution", 0.6},
                          {"shear-rate", 3.7},
                          {"heap-height", 40},
                          {"height", 17},
                          {"distance", 23},
                          {"area", 911},
                          {"slope", 0.4},
                          {"kink-length", 2.7},
                          {"particles", 31},
                          {"gravity", 9.4},
                          {"time", 1.7},
                          {"velocity", -0.8},
                          {"end-velocity", 0.3},
                          {"end-height", 5},
                          {"kinetic-energy", 7.7},
                          {"floor", 2.9},
                          {"bottom-speed", 0.55},
                          {"layers", 4.5},
                          {"width", 6.6},
                          {"bottom-restitution", 0.85},
                          {"side-restitution", 0.95},
                          {"mean-count", 71},
                          {"share", 0.15},
                          {"variance", 1.9},
                          {"length", 37},
                          {"cell-edge", 2.5},
                          {"window", 3},
                          {"samples", 512},
                          {"impact-coefficient", 0.35},
                          {"impact-parameter", 0.45}};

const Gas kGas{
    .dimension = 3, .diameter = 0.7, .mass = 1.3, .temperature = 2.1, .fraction = 0.2, .restitution = 0.6};
constexpr Heap kHeap{40, 0.4, 2.7};
constexpr FallingParticles kParticles{31, 1.3, 9.4, 17, -0.8};
constexpr VibratedBed kBed{3, 4.5, 6.6, 0.6, 0.85, 0.95, 9.4, 0.55};

double value(const std::string& name) {
  const Law& law = find_law(name);
  Arguments arguments;
  for (const Parameter& parameter : law.parameters)
    if (const auto known = kKnown.find(parameter.name); known != kKnown.end()) arguments.insert(*known);
  return evaluate(law, arguments);
}

void expect_values(const std::map<std::string, double>& expected) {
  for (const auto& [name, number] : expected) EXPECT_DOUBLE_EQ(value(name), number) << name;
}

TEST(CatalogueOfFlows, ShearLawsTakeTheirArguments) {
  const ReducedStress stress = dilute_shear_stress(3, 0.6);
  expect_values({{"uniform-shear-rate-dilute", dilute_shear_rate(3, 0.6)},
                 {"uniform-shear-xx-stress-dilute", stress.xx},
                 {"uniform-shear-yy-stress-dilute", stress.yy},
                 {"uniform-shear-xy-stress-dilute", stress.xy},
                 {"uniform-shear-friction-dilute", stress.xy / stress.yy},
                 {"uniform-shear-temperature-dilute", dilute_shear_temperature(kGas, 3.7)},
                 {"inelastic-shear-viscosity", inelastic_shear_viscosity(kGas)},
                 {"uniform-shear-temperature", shear_temperature(kGas, 3.7)},
                 {"uniform-shear-stress", shear_stress(kGas, 3.7)},
                 {"uniform-shear-pressure", shear_pressure(kGas, 3.7)}});
}

TEST(CatalogueOfFlows, HeapLawsTakeTheirArguments) {
  expect_values({{"heap-distance", heap_distance(kHeap, 17)},
                 {"heap-surface", heap_surface(kHeap, 23)},
                 {"heap-area", heap_area(kHeap)},
                 {"heap-height", heap_height(911, 0.4, 2.7)}});
}

TEST(CatalogueOfFlows, FallingLawsTakeTheirArguments) {
  expect_values({{"falling-height", falling_height(kParticles, 1.7)},
                 {"falling-velocity", falling_velocity(kParticles, 1.7)},
                 {"fall-time", fall_time(17, -0.8, 9.4)},
                 {"floor-impulse", floor_impulse(kParticles, 1.7, 0.3)},
                 {"collapse-loss", collapse_loss(kParticles, 5, 7.7)},
                 {"packed-height", packed_height(kGas, 31, 2.9)},
                 {"steady-wall-friction", steady_wall_friction(kParticles)}});
}

TEST(CatalogueOfFlows, BedLawsTakeTheirArguments) {
  expect_values({{"vibrated-bed-temperature", vibrated_bed_temperature_over_mass(kBed)},
                 {"vibrated-bed-rise", vibrated_bed_rise(kBed)},
                 {"vibrated-bed-exponent", vibrated_bed_exponent(kBed)},
                 {"vibrated-bed-expansion", vibrated_bed_expansion(kBed)}});
}

TEST(CatalogueOfFlows, CountAndImpactLawsTakeTheirArguments) {
  expect_values({{"count-variance", count_variance(kGas, 71, 0.15)},
                 {"cell-count-variance", cell_count_variance(kGas, 71, 0.15, 37, {2.5, 3})},
                 {"white-spectrum-level", white_spectrum_level(1.9, 512)},
                 {"impact-normalisation", impact_normalisation(3, 0.35)},
                 {"impact-dissipation-ratio", impact_dissipation_ratio(3, 0.35)},
                 {"impact-cumulative", impact_cumulative(3, 0.35, 0.45)}});
}

}  // namespace
}  // namespace sandglass::law::catalogue_flows_test

#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/mixing.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Frames of two and three particles of a mixing fluid: right ones agree, wrong ones do not.

namespace sandglass::repulsion_test {
namespace {

std::string scene(const std::string& method, const std::string& particles, const std::string& masses) {
  return "[run]\nduration = { steps = 200 }\n[domain]\ndimension = 2\nsize = [400.0, 400.0]\n"
         "sides = { x = \"specular\", y = \"specular\" }\n" +
         masses + "[method]\npreset = \"mixing\"\nrepulsion-exponent = 2\n" + method +
         "[initial]\npositions = \"given\"\n" + particles +
         "[output]\nids = true\ntrajectory = { steps = 1 }\n";
}

std::string species(const std::string& name, double mass) {
  return "[[species]]\nname = \"" + name + "\"\ndiameter = 20.0\nmass = " + std::to_string(mass) + '\n';
}

std::string particle(const std::string& kind, const std::string& position, const std::string& velocity) {
  return "[[particle]]\nspecies = \"" + kind + "\"\nposition = " + position + "\nvelocity = " + velocity +
         '\n';
}

Frame frame(std::uint64_t step, const std::vector<double>& positions, const std::vector<double>& velocities) {
  Frame all{step, static_cast<double>(step), positions, velocities};
  for (std::uint64_t id = 0; 2 * id < positions.size(); ++id) all.columns.append(column::id, id);
  return all;
}

double excess(const std::string& check, const Record& record) {
  const Evidence evidence = run_check(find_check(check), record, {});
  return std::abs(evidence.value - evidence.expected) - evidence.budget.systematic;
}

/// Relative speed 400 along x, the second particle 40 behind and 5 beside: its velocity turns towards y.
TEST(Repulsion, PairTurnsByTheAngleOfItsOrbit) {
  const law::PairRepulsion repulsion{1000, 2, 5, 0, 20, 30};
  for (const double factor : {1.0, 1.05}) {
    Record record;
    record.scene =
        scene("time-step = 1e-4\nrepulsion-coefficient = 1000.0\ncore-exponent = 5\ncutoff = 30.0\n",
              particle("heavy", "[200.0, 200.0]", "[-100.0, 0.0]") +
                  particle("light", "[160.0, 205.0]", "[300.0, 0.0]"),
              species("heavy", 25) + species("light", 10));
    record.replicas.resize(1);
    const double angle = factor * law::deflection_angle(repulsion, 35, 400, 5);
    record.trajectory.push_back(frame(0, {200, 200, 160, 205}, {-100, 0, 300, 0}));
    record.trajectory.push_back(
        frame(200, {150, 150, 250, 250}, {0, 0, 400 * std::cos(angle), 400 * std::sin(angle)}));
    EXPECT_EQ(excess("pair-deflection", record) <= 0, factor == 1);
  }
}

/// The leapfrog of a spring, step by step.
TEST(Repulsion, LightParticleInACageFollowsTheLeapfrog) {
  const law::PairRepulsion repulsion{1, 2, 2, 0, 20, 15};
  const double dt = 0.1, frequency = law::cage_frequency(repulsion, 1, 10);
  for (const double factor : {1.0, 1.01}) {
    Record record;
    record.scene =
        scene("time-step = 0.1\nrepulsion-coefficient = 1.0\ncore-exponent = 2\ncutoff = 15.0\n",
              particle("light", "[200.001, 200.0]", "[0.0, 0.0]") +
                  particle("heavy", "[190.0, 200.0]", "[0.0, 0.0]") +
                  particle("heavy", "[210.0, 200.0]", "[0.0, 0.0]"),
              "[[species]]\nname = \"light\"\ndiameter = 20.0\nmass = 1e-14\n" + species("heavy", 1));
    record.replicas.resize(1);
    const double kick = std::pow(factor * frequency * dt, 2);
    double before = 0.001, place = before * (1 - kick / 2);  // half a kick at the start
    record.trajectory.push_back(frame(0, {200.001, 200, 190, 200, 210, 200}, std::vector<double>(6)));
    for (std::uint64_t step = 1; step <= 200; ++step) {
      record.trajectory.push_back(
          frame(step, {200 + place, 200, 190, 200, 210, 200}, std::vector<double>(6)));
      const double next = 2 * place - before - kick * place;
      before = place, place = next;
    }
    EXPECT_EQ(excess("leapfrog-in-a-cage", record) <= 0, factor == 1);
  }
}

}  // namespace
}  // namespace sandglass::repulsion_test

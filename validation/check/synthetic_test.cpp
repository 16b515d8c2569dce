#include "validation/check/synthetic.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace sandglass::synthetic {

std::string GasScene::text() const {
  std::string method = "preset = \"cba\"\ncells = [2, 2]\ntime-step = { collisions-per-particle = 0.01 }\n";
  if (event_driven) method = "preset = \"event-driven\"\ntime-step = 0.1\n";
  if (contact_time > 0)
    method += fmt::format("collapse-guard = \"contact-time\"\ncontact-time = {}\n", contact_time);
  if (event_driven)
    method += "[initial]\npositions = \"lattice\"\n";
  else
    method += "[initial]\n";
  const double edge = std::sqrt(particles * std::numbers::pi / 4 / area_fraction);
  return fmt::format(
      "title = \"synthetic\"\n[run]\nseed = 1\nduration = {{ steps = 100 }}\n"
      "[domain]\ndimension = 2\nsize = [{0}, {0}]\n"
      "[[species]]\ncount = {1}\nrestitution = {2}\n"
      "[method]\n{5}{3}\n{4}\n",
      edge, particles, restitution, initial, observe, method);
}

Record record_of(const GasScene& scene, std::size_t replicas) {
  Record record;
  record.scene = scene.text();
  record.replicas.resize(replicas);
  return record;
}

Series& add_series(Record& record, std::size_t replica, const std::string& name,
                   const std::vector<std::string>& components) {
  Series series;
  series.quantity.name = name;
  series.quantity.components = components;
  if (!components.empty()) series.quantity.shape = {components.size()};
  record.replicas.at(replica).series.push_back(series);
  return record.replicas.at(replica).series.back();
}

void add_sample(Series& series, double time, const std::vector<double>& values) {
  series.step.push_back(series.step.size());
  series.time.push_back(time);
  series.value.insert(series.value.end(), values.begin(), values.end());
}

std::vector<double> microcanonical(Generator& generator, int particles) {
  std::normal_distribution<double> normal;
  std::vector<double> velocity(2 * static_cast<std::size_t>(particles));
  for (double& component : velocity) component = normal(generator);
  double mean[2] = {0, 0}, squares = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i) mean[i % 2] += velocity[i] / particles;
  for (std::size_t i = 0; i < velocity.size(); ++i) squares += std::pow(velocity[i] -= mean[i % 2], 2);
  for (double& component : velocity) component *= std::sqrt(2.0 * (particles - 1) / squares);
  return velocity;
}

TEST(Synthetic, SceneIsReadAndUniform) {
  const Record record = record_of({}, 1);
  const Subject subject(record);
  EXPECT_NEAR(subject.gas(1).fraction, 0.25, 1e-12);
  EXPECT_EQ(subject.particles(), 1000);
  EXPECT_EQ(subject.particles_per_cell(), 250);
}

TEST(Synthetic, MicrocanonicalHasUnitTemperature) {
  Generator generator(1);
  const std::vector<double> velocity = microcanonical(generator, 10);
  double squares = 0, sum = 0;
  for (std::size_t i = 0; i < velocity.size(); ++i) squares += velocity[i] * velocity[i], sum += velocity[i];
  EXPECT_NEAR(squares, 2 * 9, 1e-12);
  EXPECT_NEAR(sum, 0, 1e-12);
}

}  // namespace sandglass::synthetic

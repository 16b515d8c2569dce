#include "validation/check/sedimentation.hpp"

#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/law/isolated_column.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace sandglass {

namespace {
bool keeps_energy(const Scene& scene, const Species& species) {
  const double tangential = is_rough(scene) ? 1 : -1;
  return species.restitution == 1 && species.tangential_restitution == tangential && !species.friction;
}

bool is_between_mirrors(const Scene& scene, std::size_t axis) {
  return is_periodic_along(scene, axis) ||
         (is_mirror(wall_at(scene, axis, false)) && is_mirror(wall_at(scene, axis, true)));
}

double freedom(const Scene& scene) {
  const int dimension = scene.domain.dimension;
  if (!is_rough(scene)) return dimension;
  return dimension == 2 ? 3 : 6;
}

double reach_of(const Scene& scene, const Species& species) {
  return touches(scene) ? species.diameter / 2 : 0;
}

law::MixedColumn column_of(const Scene& scene, std::size_t axis, double particles) {
  law::MixedColumn column{{}, -scene.gravity[axis], freedom(scene)};
  for (const Species& species : scene.species)
    column.species.push_back({species.mass, static_cast<double>(particle_count(scene, species)) / particles,
                              scene.domain.size[axis] - 2 * reach_of(scene, species)});
  return column;
}

double at_start(const Subject& subject, std::size_t replica, const std::string& quantity,
                const std::string& component) {
  return subject.column(replica, quantity, component).front();
}

/// Kinetic, rotational and potential energy of a particle at time zero, heights counted as the law does.
double start_energy(const Subject& subject, std::size_t replica, const law::MixedColumn& column,
                    std::size_t axis, double particles) {
  double moving = at_start(subject, replica, "energy", "");
  if (is_rough(subject.scene())) moving += at_start(subject, replica, "rotational-energy", "");
  double mass = 0, lowest = 0;
  for (std::size_t i = 0; i < column.species.size(); ++i) {
    mass += column.species[i].share * column.species[i].mass;
    lowest += column.species[i].share * column.species[i].mass *
              reach_of(subject.scene(), subject.scene().species[i]);
  }
  const std::string up(1, static_cast<char>('x' + axis));
  return moving / (particles * subject.scene().method.weight) +
         column.gravity * (mass * at_start(subject, replica, "centre-of-mass", up) - lowest);
}

/// Second virial coefficient of two species: half of what their centres exclude.
double virial(int dimension, double distance) {
  return std::numbers::pi *
         (dimension == 2 ? distance * distance / 2 : 2 * distance * distance * distance / 3);
}
}  // namespace

bool is_sedimentation(const Scene& scene) {
  if (!capabilities(scene).collisions || vertical_axis(scene) < 0 || !scene.obstacles.empty() ||
      !scene.given.empty() || !scene.sources.empty() || has_open_side(scene.domain))
    return false;
  const auto up = static_cast<std::size_t>(vertical_axis(scene));
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis)
    if (!is_between_mirrors(scene, axis)) return false;
  return !is_periodic_along(scene, up) &&
         std::all_of(scene.species.begin(), scene.species.end(),
                     [&scene](const Species& species) { return keeps_energy(scene, species); });
}

Sedimentation::Sedimentation(const Subject& subject)
    : subject_(subject), axis_(static_cast<std::size_t>(vertical_axis(subject.scene()))) {
  const Scene& scene = subject.scene();
  particles_ = static_cast<double>(particle_count(scene));
  column_ = column_of(scene, axis_, particles_);
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    energy_.push_back(start_energy(subject, replica, column_, axis_, particles_));
  end_ = temperature(all());
}

std::vector<std::size_t> Sedimentation::all() const {
  std::vector<std::size_t> replicas(energy_.size());
  std::iota(replicas.begin(), replicas.end(), 0);
  return replicas;
}

double Sedimentation::temperature(Some replicas) const {
  double energy = 0;
  for (const std::size_t replica : replicas) energy += energy_[replica];
  return law::sedimentation_temperature(column_, energy / static_cast<double>(replicas.size()));
}

double Sedimentation::temperature(std::size_t replica) const {
  return law::sedimentation_temperature(column_, energy_[replica]);
}

law::Column Sedimentation::part(std::size_t species, double temperature) const {
  return {column_.species[species].mass, temperature, column_.gravity, column_.species[species].height};
}

double Sedimentation::height() const { return subject_.scene().domain.size[axis_]; }

double Sedimentation::reach(std::size_t species) const {
  return reach_of(subject_.scene(), subject_.scene().species[species]);
}

double Sedimentation::rest_height(double temperature) const {
  double moment = 0, mass = 0;
  for (std::size_t i = 0; i < species(); ++i) {
    const double share = column_.species[i].share * column_.species[i].mass;
    moment += share * (reach(i) + law::mean_column_height(part(i, temperature)));
    mass += share;
  }
  return moment / mass;
}

std::vector<double> Sedimentation::heights(std::size_t replica) const {
  return subject_.column(replica, "centre-of-mass", std::string(1, static_cast<char>('x' + axis_)));
}

double Sedimentation::capacity() const { return law::heat_capacity(column_, end_, particles_); }

/// Up to 2/NC between the temperatures of a fixed energy and of a bath, and D - 1 momenta that stay zero: they are no
/// degrees of freedom, but a temperature counts them. A density that is off by delta(z) moves the mean of w = m g z/T by
/// <w delta>, at most delta times the spread of w, and the temperature by that over C.
double Sedimentation::mean_shift() const {
  double variance = 0;
  for (std::size_t i = 0; i < species(); ++i)
    variance = std::max(variance, law::column_height_variance(part(i, end_)));
  return (2 + (subject_.dimension() - 1) / 2.0) / capacity() +
         size_shift() * std::sqrt(variance) * particles_ / capacity();
}

double Sedimentation::density_shift() const {
  double shift = 0;
  for (std::size_t i = 0; i < species(); ++i) {
    const law::Column own = part(i, end_);
    const law::IsolatedColumn shifts(own, capacity());
    for (const double z : {0.0, shifts.largest_density_height(), own.height})
      shift = std::max(shift, std::abs(shifts.density_shift(z)));
  }
  return shift + size_shift();
}

double Sedimentation::temperature_shift(double bins) const {
  double shift = 0, fewest = particles_;
  for (std::size_t i = 0; i < species(); ++i) {
    const law::Column own = part(i, end_);
    const law::IsolatedColumn shifts(own, capacity());
    for (const double z : {0.0, own.height}) shift = std::max(shift, std::abs(shifts.temperature_shift(z)));
    fewest = std::min(fewest, particles_ / bins * law::column_density(own, own.height));
  }
  return mean_shift() + shift * law::weight_of_crowded_samples(fewest);
}

/// Of hard particles, and of points whose collisions carry the same pressure: each species finds less room where the others
/// are dense, to first order in their size; most at one of the ends.
double Sedimentation::size_shift() const {
  const Scene& scene = subject_.scene();
  if (!touches(scene) && !loses_pairs(scene)) return 0;
  double largest = 0;
  for (const Species& one : scene.species) {
    double low = 0, high = 0;
    for (std::size_t j = 0; j < species(); ++j) {
      const double mean = particles_ * column_.species[j].share / volume(scene.domain);
      const double pair = 2 * virial(scene.domain.dimension, (one.diameter + scene.species[j].diameter) / 2);
      low += pair * mean * law::column_density(part(j, end_), 0);
      high += pair * mean * law::column_density(part(j, end_), column_.species[j].height);
    }
    largest = std::max(largest, low - high);
  }
  return largest;
}

}  // namespace sandglass

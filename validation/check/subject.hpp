#pragma once

#include "sim/base/statistics.hpp"
#include "sim/record/record.hpp"
#include "sim/scene/scene.hpp"
#include "validation/law/gas.hpp"
#include "validation/law/virial.hpp"

#include <span>
#include <string>
#include <vector>

namespace sandglass {

/// What a check looks at: a record and the scene that it carries, read back. Keeps a reference to the record.
class Subject {
 public:
  /// Throws InputError when the record's scene cannot be read or holds no finished replica.
  explicit Subject(const Record& record);

  const Record& record() const { return *record_; }
  const Scene& scene() const { return scene_; }
  std::size_t replicas() const { return record_->replicas.size(); }
  int dimension() const { return scene_.domain.dimension; }
  const Species& species() const { return scene_.species.front(); }
  double particles() const { return particles_; }                               ///< simulated, per replica
  double degrees_of_freedom() const { return dimension() * (particles_ - 1); }  ///< thermal ones, per replica
  double particles_per_cell() const;   ///< 0 when the method has no cells
  double collisions_per_step() const;  ///< of one particle, at the initial temperature

  /// An offset pushes particles apart, so that a cell holds fewer pairs than chance would give it, and the window of its
  /// contact value scatters less: law::pair_deficit. Whatever is proportional to pairs is too small by that part. Nothing
  /// without an offset or without cells. Cells that are full keep their numbers, and no window corrects them: between
  /// nothing and (1 - S)/N_c.
  law::Bounded missing_pairs() const;

  /// Pairs that can collide over those of an infinite gas: (N-1)/N where partners are drawn at random, and
  /// fixed_count_factor where hard particles really touch.
  double pair_factor() const;

  /// The gas of the scene at the given temperature, for laws.
  law::Gas gas(double temperature) const;

  bool has(const std::string& quantity) const;
  /// Throws InputError naming the observer that the scene lacks.
  const Series& series(std::size_t replica, const std::string& quantity) const;
  /// One component over the samples of one replica; component "" of a scalar. Throws InputError on an unknown
  /// one.
  std::vector<double> column(std::size_t replica, const std::string& quantity,
                             const std::string& component) const;
  /// Collisions per particle at each sample of a series.
  std::vector<double> collisions_per_particle(std::size_t replica, const Series& series) const;
  /// The run's own granular temperature: mean over samples and replicas of a stationary gas.
  double mean_temperature() const;

 private:
  const Record* record_;
  Scene scene_;
  double particles_;
};

/// The collision rate has the contact value in it: of particles with a surface, or as a factor.
bool has_contact_value(const Scene& scene);

/// Mean over replicas of a stationary quantity. Eight or more replicas are taken as independent samples;
/// fewer are each given the error of a correlated series.
Mean pooled(const std::vector<std::vector<double>>& samples_of_replicas);

}  // namespace sandglass

#pragma once

#include "validation/check/subject.hpp"
#include "validation/law/sedimentation.hpp"

#include <span>

/// A closed column of gas that starts evenly spread and sinks under gravity between mirrors: one species or several, smooth or
/// perfectly rough.
namespace sandglass {

/// Collisions and walls keep the energy, gravity points along one axis to a mirror.
bool is_sedimentation(const Scene& scene);

class Sedimentation {
 public:
  explicit Sedimentation(const Subject& subject);

  using Some = std::span<const std::size_t>;  ///< replicas

  /// Of equilibrium, by the law, at the mean of the energies that these replicas start with.
  double temperature(Some replicas) const;
  double temperature(std::size_t replica) const;
  const law::MixedColumn& column() const { return column_; }
  law::Column part(std::size_t species, double temperature) const;
  std::size_t species() const { return column_.species.size(); }
  std::size_t axis() const { return axis_; }
  std::vector<std::size_t> all() const;  ///< replicas
  double height() const;
  double reach(std::size_t species) const;  ///< how far its centres stay from floor and lid
  double particles() const { return particles_; }

  /// Height of the centre of mass in equilibrium.
  double rest_height(double temperature) const;
  /// Of the centre of mass at each sample; the times are those of the series.
  std::vector<double> heights(std::size_t replica) const;

  /// What finite N leaves of the law, to first order, as shares: of a temperature that is the mean of all particles, and the
  /// largest of density and temperature anywhere.
  double mean_shift() const;
  double density_shift() const;
  double temperature_shift(double bins) const;

 private:
  double capacity() const;  ///< N C at the temperature of equilibrium
  double size_shift() const;

  const Subject& subject_;
  std::size_t axis_;
  law::MixedColumn column_;
  double particles_ = 0;
  std::vector<double> energy_;  ///< per particle, of each replica at time zero
  double end_;                  ///< temperature of equilibrium, all replicas
};

}  // namespace sandglass

#pragma once

#include "validation/check/subject.hpp"

#include <span>

/// A gas between two rough walls across y that move along x in opposite directions.
namespace sandglass {

bool is_shear_cell(const Scene& scene);

/// Density times velocity along x in each bin across y, averaged over the samples from a time on.
std::vector<double> momentum_along(const Subject& subject, std::size_t replica, double from);

/// What a set of replicas shows on average from a time on.
class ShearCell {
 public:
  ShearCell(const Subject& subject, double settle_time);

  using Some = std::span<const std::size_t>;
  struct Bulk {
    double density = 0, temperature = 0;
    double rate = 0;  ///< slope of the velocity along x
  };
  /// Of the bins whose centres lie in the middle `share` of the height.
  Bulk bulk(Some replicas, double share) const;
  /// Slope of a straight profile between the centres of particles at either wall. The walls of the scene move apart, so
  /// it is never zero, whatever the gas does.
  double wall_rate() const;
  double shear_stress(Some replicas) const { return average(shear_, replicas); }  ///< of both walls, positive
  double normal_stress(Some replicas) const { return average(normal_, replicas); }  ///< of both walls
  /// Work of both walls less the gain of energy, per time.
  double dissipated(Some replicas) const { return average(dissipated_, replicas); }

  std::size_t bins() const { return density_.front().size(); }
  double height(std::size_t bin) const;  ///< of its centre
  double density(Some replicas, std::size_t bin) const;
  double velocity(Some replicas, std::size_t bin) const;
  double temperature(Some replicas, std::size_t bin) const;
  /// Real particles whose bins hold these.
  law::Gas gas(double density, double temperature) const;

 private:
  using Rows = std::vector<std::vector<double>>;  ///< [replica][bin]
  static double average(const std::vector<double>& values, Some replicas);

  const Subject& subject_;
  double box_height_;
  Rows density_, momentum_, temperature_;
  std::vector<double> shear_, normal_, dissipated_;
};

}  // namespace sandglass

#pragma once

#include "sim/observe/observer.hpp"

namespace sandglass {

/// Granular temperature of each species of a mixture, about the velocity of the centre of mass of all.
template <int D>
class SpeciesTemperature final : public Observer<D> {
 public:
  explicit SpeciesTemperature(const ObserverSpec& spec) : species_(spec.species) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;

 private:
  std::vector<std::string> species_;
};

/// Collisions by pair of species since time zero; each pair of two species once.
template <int D>
class SpeciesCollisions final : public Observer<D> {
 public:
  explicit SpeciesCollisions(const ObserverSpec& spec) : species_(spec.species) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool cumulative() const override { return true; }

 private:
  std::vector<std::string> species_;
};

}  // namespace sandglass

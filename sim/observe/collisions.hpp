#pragma once

#include "sim/observe/observer.hpp"

namespace sandglass {

/// Collisions, or candidates, since time zero.
template <int D>
class CollisionCount final : public Observer<D> {
 public:
  explicit CollisionCount(bool candidates) : candidates_(candidates) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool sums_up() const override { return true; }
  bool cumulative() const override { return true; }

 private:
  bool candidates_;
};

/// Kinetic and collisional pressure over the time since the previous sample. The collisional part is
/// sum of Tally::transfer / (D V dt): the virial sum J . (r_1 - r_2) of hard particles (J the momentum that particle 1
/// gains), or what the offsets of a method without contacts really carried, sum m v' . displacement.
template <int D>
class Pressure final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool sums_up() const override { return true; }
  bool measures_at_start() const override { return false; }
  void start(const View<D>& view) override;
  std::vector<double> save() const override;
  void load(const std::vector<double>& state) override;

 private:
  double kinetic(const View<D>& view) const;

  double time_ = 0, kinetic_ = 0;
  ExactSum transfer_;
};

/// Collisions by the impact parameter |b|/d in equal bins over [0, 1], since the previous sample. Without correlations
/// P(b) is flat for disks and grows as b for spheres.
template <int D>
class ImpactParameter final : public Observer<D> {
 public:
  explicit ImpactParameter(const ObserverSpec& spec) : bins_(spec.bins), before_(spec.bins) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool measures_at_start() const override { return false; }
  void start(const View<D>& view) override;
  std::vector<double> save() const override;
  void load(const std::vector<double>& state) override;

 private:
  std::size_t bins_;
  std::vector<std::uint64_t> before_;  ///< counts at the previous sample
};

/// Deepest overlap of two particles at a collision since time zero, in diameters.
template <int D>
class Overlap final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
};

/// Passages of a plane by normal velocity, since the previous sample.
template <int D>
class Crossings final : public Observer<D> {
 public:
  Crossings(const ObserverSpec& spec, std::size_t plane) : spec_(spec), plane_(plane) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool sums_up() const override { return true; }
  bool measures_at_start() const override { return false; }
  void start(const View<D>& view) override { measure(view); }

 private:
  ObserverSpec spec_;
  std::size_t plane_;
};

/// Passages of a plane since time zero, upwards and downwards.
template <int D>
class CrossingCount final : public Observer<D> {
 public:
  explicit CrossingCount(std::size_t plane) : plane_(plane) {}
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool sums_up() const override { return true; }
  bool cumulative() const override { return true; }

 private:
  std::size_t plane_;
};

}  // namespace sandglass

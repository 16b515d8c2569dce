#pragma once

#include "sim/observe/observer.hpp"

// Energy, granular temperature and momentum. Source: definitions (docs/notation.md).

namespace sandglass {

/// Kinetic energy of all real particles.
template <int D>
class Energy final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool sums_up() const override { return true; }
};

/// Granular temperature per axis and their mean.
template <int D>
class Temperature final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool sums_up() const override { return true; }
};

/// Total momentum of the real particles.
template <int D>
class Momentum final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool sums_up() const override { return true; }
};

/// Sum of m|v|: what the rounding of the total momentum is measured by.
template <int D>
class MomentumScale final : public Observer<D> {
 public:
  Quantity quantity() const override;
  std::vector<double> measure(const View<D>& view) override;
  bool sums_up() const override { return true; }
};

}  // namespace sandglass

#pragma once

#include "sim/base/series.hpp"
#include "sim/observe/view.hpp"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace sandglass {

/// What an observer makes the method do besides running. Nothing undeclared is computed.
struct Needs {
  bool transfer = false;        ///< Tally::transfer
  bool plane = false;           ///< a Plane
  bool walls = false;           ///< WallImpulses
  std::size_t impact_bins = 0;  ///< size of Tally::impact; 0: not counted
  bool by_species = false;      ///< Tally::by_species
};

/// Measures one quantity. Called at the start of the run (unless it measures over intervals) and at every sample.
template <int D>
class Observer {
 public:
  virtual ~Observer() = default;
  virtual Quantity quantity() const = 0;
  virtual std::vector<double> measure(
      const View<D>& view) = 0;  ///< empty: no sample (a mean of no particles)
  /// It takes nothing of the particles but sums as of sum_particles(), and counts: where ranks share the particles it sees
  /// those of its rank, and nobody gathers them.
  virtual bool sums_up() const { return false; }
  /// False for what is measured over the time since the previous sample.
  virtual bool measures_at_start() const { return true; }
  /// A count since time zero: its estimate is a rate.
  virtual bool cumulative() const { return false; }
  /// Called once at time zero, before the first sample.
  virtual void start(const View<D>&) {}
  /// Running state, for checkpoints.
  virtual std::vector<double> save() const { return {}; }
  virtual void load(const std::vector<double>&) {}
};

/// One observer as the scene asks for it; each reads what it needs.
struct ObserverSpec {
  std::string what;
  int axis = 0;
  double position = 0;
  std::array<double, 2> range{-5, 5};
  std::size_t bins = 64;
  std::vector<std::size_t> grid;
  int periods = 1;                   ///< shear-mode
  std::vector<int> bounded;          ///< axes of the box that are not periodic
  std::vector<std::string> species;  ///< names of the species
};

Needs needs_of(const ObserverSpec& spec);
/// Rising edges of `bins` equal bins over the range.
std::vector<double> bin_edges(const ObserverSpec& spec);

/// One spec may stand for several quantities. `plane` is the index of the plane of this spec, if it needs one.
/// Throws InputError for a name that is not known.
template <int D>
std::vector<std::unique_ptr<Observer<D>>> make_observers(const ObserverSpec& spec, std::size_t plane);

}  // namespace sandglass

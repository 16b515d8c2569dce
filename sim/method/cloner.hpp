#pragma once

#include "sim/base/random.hpp"
#include "sim/method/simulator.hpp"
#include "sim/observe/cloning_sums.hpp"
#include "sim/space/particle_store.hpp"

#include <span>
#include <vector>

namespace sandglass {

/// Faults that the mutant suite plants.
struct CloningFaults {
  bool clones_keep_weight = false;     ///< the copies of a particle keep its weight
  bool survivors_keep_weight = false;  ///< who stays when others are removed keeps its weight
};

/// Keeps every particle at the weight of its cell. One that crosses from weight w1 to w2 becomes w1/w2 particles of weight
/// w2 in the mean: the whole part, and one more with the probability of the rest (Kawasaki 1986, 4.4 and its routine
/// WEIGHT). Copies start where it stands, with its velocity and spin.
template <int D>
class Cloner {
 public:
  /// `weights` of each cell; the sums of `tally` are taken from then on.
  Cloner(std::vector<double> weights, const CloningFaults& faults, Tally& tally);

  /// All particles of a store between the flight and the sort, when they stand in their old cells and know the new ones.
  void apply(ParticleStore<D>& store, std::span<const SpeciesTraits> traits, const StreamKey& key);
  /// Particles on their way into the store, that came in with a weight of their own.
  void apply(Particles<D>& entrants, const ParticleStore<D>& store, std::span<const SpeciesTraits> traits,
             const StreamKey& key);

  std::map<std::string, double> counters() const;
  std::vector<double> save() const;
  void load(const std::vector<double>& state);
  std::size_t bytes() const { return weights_.capacity() * sizeof(double); }

 private:
  /// A particle at a border.
  struct Crossing {
    const Vector<D>& velocity;
    double mass, from, to;
  };
  std::uint64_t copies_of(const Crossing& crossing, Random random);
  double new_weight(double own, const Crossing& crossing) const;
  void count(const Crossing& crossing, double own, double copies, double carried);

  std::vector<double> weights_;
  CloningFaults faults_;
  Tally& tally_;
  double cloned_ = 0, removed_ = 0;  ///< particles, since time zero
};

extern template class Cloner<2>;
extern template class Cloner<3>;

}  // namespace sandglass

#include "sim/method/cloner.hpp"

#include "sim/base/error.hpp"
#include "sim/motion/stream_index.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double kMostInAStep = 1e6;

void require_few(double copies) {
  if (copies > kMostInAStep)
    throw RunError(
        fmt::format("{:.4g} copies are made of particles that cross into a [[region]] of lower weight in one "
                    "step; at most {} are allowed: raise its 'weight', put regions of weights between, or "
                    "shorten 'method.time-step'",
                    copies, kMostInAStep));
}

double mass_of(std::span<const SpeciesTraits> traits, std::span<const std::uint8_t> species, std::size_t i) {
  return traits[species.empty() ? 0 : species[i]].mass;
}
}  // namespace

template <int D>
Cloner<D>::Cloner(std::vector<double> weights, const CloningFaults& faults, Tally& tally)
    : weights_(std::move(weights)), faults_(faults), tally_(tally) {
  tally_.cloning.resize(CloningSums<D>::kSize);
}

template <int D>
std::uint64_t Cloner<D>::copies_of(const Crossing& crossing, Random random) {
  const double ratio = crossing.from / crossing.to, whole = std::floor(ratio);
  require_few(whole);
  return static_cast<std::uint64_t>(whole) + (random.uniform() < ratio - whole ? 1 : 0);
}

template <int D>
double Cloner<D>::new_weight(double own, const Crossing& crossing) const {
  const bool cloned = crossing.to < crossing.from;
  return (cloned ? faults_.clones_keep_weight : faults_.survivors_keep_weight) ? own : crossing.to;
}

/// The number of copies, floor(q) and one more with probability f, has the variance f (1 - f).
template <int D>
void Cloner<D>::count(const Crossing& crossing, double own, double copies, double carried) {
  using Sums = CloningSums<D>;
  const bool removed = crossing.to > crossing.from;
  if (copies > 1) cloned_ += copies - 1;
  if (copies == 0) ++removed_;
  const double ratio = crossing.from / crossing.to, rest = ratio - std::floor(ratio);
  const double gained = copies * carried - own, variance = crossing.to * crossing.to * rest * (1 - rest);
  const auto add = [&](std::size_t amount, double value) {
    tally_.cloning[Sums::place(Sums::brought, removed, amount)].add(own * std::abs(value));
    tally_.cloning[Sums::place(Sums::gained, removed, amount)].add(gained * value);
    tally_.cloning[Sums::place(Sums::variance, removed, amount)].add(variance * value * value);
  };
  add(0, crossing.mass);
  for (int axis = 0; axis < D; ++axis)
    add(static_cast<std::size_t>(1 + axis), crossing.mass * crossing.velocity[axis]);
  add(D + 1, crossing.mass * crossing.velocity.squaredNorm() / 2);
}

template <int D>
void Cloner<D>::apply(ParticleStore<D>& store, std::span<const SpeciesTraits> traits, const StreamKey& key) {
  const auto offsets = store.offsets();
  const auto* places = store.places();
  const auto weights = store.column(column::weight);
  const auto species = store.column(column::species);
  std::vector<std::uint32_t> leaving, copied;
  for (std::uint32_t cell = 0; cell + 1 < offsets.size(); ++cell)
    for (std::uint32_t i = offsets[cell]; i < offsets[cell + 1]; ++i) {
      const std::uint32_t arrives = places[i].cell;
      if (arrives == store.removed() || weights_[arrives] == weights_[cell]) continue;
      const Crossing crossing{store.phases()[i].velocity, mass_of(traits, species, i), weights_[cell],
                              weights_[arrives]};
      const std::uint64_t copies =
          copies_of(crossing, Random(key, motion::stream_index(cell, i - offsets[cell])));
      const double own = weights[i];
      weights[i] = new_weight(own, crossing);
      count(crossing, own, static_cast<double>(copies), weights[i]);
      if (copies == 0) leaving.push_back(i);
      for (std::uint64_t n = 1; n < copies; ++n) copied.push_back(i);
      require_few(static_cast<double>(copied.size()));
    }
  if (!copied.empty()) store.insert(pick<D>(store.phases(), store.columns(), copied));
  if (!leaving.empty()) store.drop(leaving);
}

template <int D>
void Cloner<D>::apply(Particles<D>& entrants, const ParticleStore<D>& store,
                      std::span<const SpeciesTraits> traits, const StreamKey& key) {
  const auto weights = entrants.columns.edit(column::weight);
  const auto species = entrants.columns.get(column::species);
  std::vector<std::uint32_t> coming;
  for (std::uint32_t i = 0; i < entrants.phases.size(); ++i) {
    const Phase<D>& particle = entrants.phases[i];
    const Crossing crossing{particle.velocity, mass_of(traits, species, i), weights[i],
                            weights_[store.cells().cell_of(particle.position)]};
    std::uint64_t copies = 1;
    if (crossing.from != crossing.to) {
      // No cell has this number: the draws of entrants are those of nobody else.
      copies = copies_of(crossing, Random(key, motion::stream_index(store.removed(), i)));
      weights[i] = new_weight(crossing.from, crossing);
      count(crossing, crossing.from, static_cast<double>(copies), weights[i]);
    }
    coming.insert(coming.end(), copies, i);
    require_few(static_cast<double>(coming.size()));
  }
  entrants = pick(entrants, coming);
}

template <int D>
std::map<std::string, double> Cloner<D>::counters() const {
  return {{"particles-cloned", cloned_}, {"particles-removed", removed_}};
}

template <int D>
std::vector<double> Cloner<D>::save() const {
  return {cloned_, removed_};
}

template <int D>
void Cloner<D>::load(const std::vector<double>& state) {
  cloned_ = state.at(0);
  removed_ = state.at(1);
}

template class Cloner<2>;
template class Cloner<3>;

}  // namespace sandglass

#include "sim/observe/observer.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/observe/centre_of_mass.hpp"
#include "sim/observe/cloning.hpp"
#include "sim/observe/collisions.hpp"
#include "sim/observe/distribution.hpp"
#include "sim/observe/energy.hpp"
#include "sim/observe/energy_flux.hpp"
#include "sim/observe/fields.hpp"
#include "sim/observe/free_surface.hpp"
#include "sim/observe/kinetic_stress.hpp"
#include "sim/observe/pair_correlation.hpp"
#include "sim/observe/pair_velocity.hpp"
#include "sim/observe/rotation.hpp"
#include "sim/observe/species.hpp"
#include "sim/observe/species_density.hpp"
#include "sim/observe/spin_temperature.hpp"
#include "sim/observe/structure_factor.hpp"
#include "sim/observe/two_fluids.hpp"
#include "sim/observe/wall_force.hpp"

#include <functional>
#include <map>

namespace sandglass {

namespace {

template <int D>
using List = std::vector<std::unique_ptr<Observer<D>>>;

template <int D, class... Kinds>
List<D> list(std::unique_ptr<Kinds>... observers) {
  List<D> result;
  (result.push_back(std::move(observers)), ...);
  return result;
}

/// Every word that a scene may write after `what =`.
template <int D>
const std::map<std::string, std::function<List<D>(const ObserverSpec&, std::size_t)>>& makers() {
  using std::make_unique;
  using Spec = const ObserverSpec&;
  static const std::map<std::string, std::function<List<D>(Spec, std::size_t)>> all = {
      {"energy", [](Spec, std::size_t) { return list<D>(make_unique<Energy<D>>()); }},
      {"temperature", [](Spec, std::size_t) { return list<D>(make_unique<Temperature<D>>()); }},
      {"momentum",
       [](Spec, std::size_t) {
         return list<D>(make_unique<Momentum<D>>(), make_unique<MomentumScale<D>>());
       }},
      {"moments", [](Spec, std::size_t) { return list<D>(make_unique<Moments<D>>()); }},
      {"velocity-histogram",
       [](Spec spec, std::size_t) { return list<D>(make_unique<VelocityHistogram<D>>(spec)); }},
      {"collisions",
       [](Spec, std::size_t) {
         return list<D>(make_unique<CollisionCount<D>>(false), make_unique<CollisionCount<D>>(true));
       }},
      {"cloning",
       [](Spec, std::size_t) {
         using Sums = CloningSums<D>;
         return list<D>(make_unique<Cloning<D>>(Sums::brought), make_unique<Cloning<D>>(Sums::gained),
                        make_unique<Cloning<D>>(Sums::variance));
       }},
      {"pressure", [](Spec, std::size_t) { return list<D>(make_unique<Pressure<D>>()); }},
      {"crossings",
       [](Spec spec, std::size_t plane) {
         return list<D>(make_unique<Crossings<D>>(spec, plane), make_unique<CrossingCount<D>>(plane));
       }},
      {"impact-parameter",
       [](Spec spec, std::size_t) { return list<D>(make_unique<ImpactParameter<D>>(spec)); }},
      {"overlap", [](Spec, std::size_t) { return list<D>(make_unique<Overlap<D>>()); }},
      {"rotational-energy",
       [](Spec, std::size_t) {
         return list<D>(make_unique<RotationalEnergy<D>>(), make_unique<RotationalTemperature<D>>());
       }},
      {"species",
       [](Spec spec, std::size_t) {
         return list<D>(make_unique<SpeciesTemperature<D>>(spec), make_unique<SpeciesCollisions<D>>(spec));
       }},
      {"pair-correlation",
       [](Spec spec, std::size_t) { return list<D>(make_unique<PairCorrelation<D>>(spec)); }},
      {"structure-factor",
       [](Spec spec, std::size_t) { return list<D>(make_unique<StructureFactor<D>>(spec)); }},
      {"pair-velocity",
       [](Spec spec, std::size_t) {
         using Component = typename PairVelocity<D>::Component;
         return list<D>(make_unique<PairVelocity<D>>(spec, Component::parallel),
                        make_unique<PairVelocity<D>>(spec, Component::transverse));
       }},
      {"wall-force",
       [](Spec spec, std::size_t) {
         using Kind = typename WallForce<D>::Kind;
         return list<D>(make_unique<WallForce<D>>(spec, Kind::force),
                        make_unique<WallForce<D>>(spec, Kind::power),
                        make_unique<WallForce<D>>(spec, Kind::heat));
       }},
      {"centre-of-mass", [](Spec spec, std::size_t) { return list<D>(make_unique<CentreOfMass<D>>(spec)); }},
      {"free-surface", [](Spec spec, std::size_t) { return list<D>(make_unique<FreeSurface<D>>(spec)); }},
      {"kinetic-stress", [](Spec spec, std::size_t) { return list<D>(make_unique<KineticStress<D>>(spec)); }},
      {"energy-flux", [](Spec spec, std::size_t) { return list<D>(make_unique<EnergyFlux<D>>(spec)); }},
      {"species-density",
       [](Spec spec, std::size_t) { return list<D>(make_unique<SpeciesDensity<D>>(spec)); }},
      {"spin-temperature",
       [](Spec spec, std::size_t) { return list<D>(make_unique<SpinTemperature<D>>(spec)); }},
      {"fields", [](Spec spec, std::size_t) { return list<D>(make_unique<Fields<D>>(spec)); }},
      {"two-fluids",
       [](Spec spec, std::size_t) {
         return list<D>(make_unique<FluidDensity<D>>(spec), make_unique<FluidCentre<D>>(),
                        make_unique<MixingIndex<D>>(spec));
       }},
      {"shear-mode",
       [](Spec spec, std::size_t) {
         return list<D>(make_unique<ShearMode<D>>(spec.periods, false),
                        make_unique<ShearMode<D>>(spec.periods, true));
       }},
  };
  return all;
}

}  // namespace

Needs needs_of(const ObserverSpec& spec) {
  return {.transfer = spec.what == "pressure",
          .plane = spec.what == "crossings",
          .walls = spec.what == "wall-force",
          .impact_bins = spec.what == "impact-parameter" ? spec.bins : 0,
          .by_species = spec.what == "species"};
}

std::vector<double> bin_edges(const ObserverSpec& spec) {
  std::vector<double> edges(spec.bins + 1);
  for (std::size_t i = 0; i <= spec.bins; ++i)
    edges[i] = spec.range[0] +
               (spec.range[1] - spec.range[0]) * static_cast<double>(i) / static_cast<double>(spec.bins);
  return edges;
}

template <int D>
List<D> make_observers(const ObserverSpec& spec, std::size_t plane) {
  const auto& all = makers<D>();
  if (const auto found = all.find(spec.what); found != all.end()) return found->second(spec, plane);
  std::vector<std::string> words;
  for (const auto& [word, maker] : all) words.push_back(word);
  throw InputError(unknown_word("observer", spec.what, words));
}

template List<2> make_observers<2>(const ObserverSpec&, std::size_t);
template List<3> make_observers<3>(const ObserverSpec&, std::size_t);

}  // namespace sandglass

#include "sim/run/initial_species.hpp"

#include "sim/base/random.hpp"

#include <utility>

#include <boost/random/uniform_int_distribution.hpp>

namespace sandglass {

std::vector<std::uint8_t> ordered_species(const Scene& scene) {
  std::vector<std::uint8_t> species;
  if (scene.species.size() < 2) return species;
  for (std::size_t kind = 0; kind < scene.species.size(); ++kind)
    species.insert(species.end(), particle_count(scene, scene.species[kind]),
                   static_cast<std::uint8_t>(kind));
  return species;
}

/// Fisher and Yates (Durstenfeld 1964): every order is equally likely.
std::vector<std::uint8_t> shuffled_species(const Scene& scene, const Streams& streams) {
  std::vector<std::uint8_t> species = ordered_species(scene);
  Random random(StreamKey(streams.seed, Purpose::species, streams.replica, 0), 0);
  for (std::size_t last = species.size(); last > 1; --last)
    std::swap(species[last - 1],
              species[boost::random::uniform_int_distribution<std::size_t>(0, last - 1)(random)]);
  return species;
}

}  // namespace sandglass

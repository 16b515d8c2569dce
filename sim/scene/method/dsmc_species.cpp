#include "sim/scene/method/dsmc.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr std::size_t most_species = 255;  // a particle keeps its species in one byte

/// Reports the first choice that a kind of particles cannot have: the remedy mends them all.
class Choices {
 public:
  Choices(const char* particles, Diagnostics& diagnostics)
      : particles_(particles), diagnostics_(diagnostics) {}

  void allow(bool allowed, const char* key, const char* word, const char* reason) {
    const std::string path = std::string("method.") + key;
    if (allowed || reported_ || !diagnostics_.clean(path)) return;
    reported_ = true;
    diagnostics_.report(path, fmt::format("'{}' must be \"{}\" with {}: {}; use the method 'dsmc', 'cba' "
                                          "or 'event-driven'",
                                          path, word, particles_, reason));
  }

 private:
  const char* particles_;
  Diagnostics& diagnostics_;
  bool reported_ = false;
};

void check_mixture(const Scene& scene, const DsmcOptions& dsmc, Choices& choices, Diagnostics& diagnostics) {
  choices.allow(
      dsmc.excluded_volume == ExcludedVolume::none, "excluded-volume", "none",
      "how dense a mixture packs changes with what a cell holds, and whom a cell lets in that has room "
      "for a small particle and none for a large one would decide by itself how the species part");
  if (!scene.sources.empty() && diagnostics.clean("source"))
    diagnostics.report("source", "'source' pours one species: remove it or the further [[species]]");
  if (scene.initial.positions == Positions::barometric && diagnostics.clean("initial.positions"))
    diagnostics.report("initial.positions",
                       "positions = \"barometric\" knows one mass: use \"random\" with several species");
}

void check_rough(const DsmcOptions& dsmc, Choices& choices) {
  choices.allow(dsmc.partners == Partners::cell, "partners", "cell", "partners a diameter away are smooth");
}

void check_impacts(const DsmcOptions& dsmc, Choices& choices) {
  choices.allow(dsmc.impact == ImpactDistribution::uniform, "impact", "uniform",
                "the fitted distribution is that of smooth particles of one species");
}
}  // namespace

void check_kinds(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  if (scene.species.size() > most_species)
    diagnostics.report(item_path("species", most_species),
                       fmt::format("{} species; at most {} are allowed", scene.species.size(), most_species));
  if (scene.species.size() > 1) {
    Choices choices("several species", diagnostics);
    check_mixture(scene, dsmc, choices, diagnostics);
    check_impacts(dsmc, choices);
  }
  if (is_rough(scene)) {
    Choices choices("rough contacts", diagnostics);
    check_rough(dsmc, choices);
    check_impacts(dsmc, choices);
  }
}

}  // namespace sandglass

#include "sim/scene/words.hpp"

namespace sandglass {

const Words<int>& axis_words() {
  static const Words<int> words = {{"x", 0}, {"y", 1}, {"z", 2}};
  return words;
}

const Words<Side>& side_words() {
  static const Words<Side> words = {
      {"periodic", Side::periodic}, {"specular", Side::specular}, {"open", Side::open}};
  return words;
}

const Words<std::optional<Positions>>& positions_words() {
  static const Words<std::optional<Positions>> words = {
      {"random", Positions::random},
      {"lattice", Positions::lattice},
      {"random-without-overlap", Positions::random_without_overlap},
      {"barometric", Positions::barometric},
      {"layers", Positions::layers},
      {"given", std::nullopt}};
  return words;
}

const Words<SurfaceKind>& surface_kind_words() {
  static const Words<SurfaceKind> words = {{"specular", SurfaceKind::specular},
                                           {"bounce-back", SurfaceKind::bounce_back},
                                           {"random-tangential-sign", SurfaceKind::random_tangential_sign},
                                           {"thermal", SurfaceKind::thermal}};
  return words;
}

const Words<Arrivals>& arrivals_words() {
  static const Words<Arrivals> words = {{"poisson", Arrivals::poisson}, {"even", Arrivals::even}};
  return words;
}

const Words<InflowEntry>& entry_words() {
  static const Words<InflowEntry> words = {{"flux", InflowEntry::flux},
                                           {"dispenser", InflowEntry::dispenser}};
  return words;
}

const Words<Piston>& piston_words() {
  static const Words<Piston> words = {{"specular", Piston::specular}, {"thermal", Piston::thermal}};
  return words;
}

const Words<std::pair<int, bool>>& wall_side_words() {
  static const Words<std::pair<int, bool>> words = [] {
    Words<std::pair<int, bool>> sides;
    for (const auto& [name, axis] : axis_words())
      for (const bool high : {false, true})
        sides.emplace_back(name + (high ? "-high" : "-low"), std::pair{axis, high});
    return sides;
  }();
  return words;
}

}  // namespace sandglass

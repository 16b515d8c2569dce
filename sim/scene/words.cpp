#include "sim/scene/words.hpp"

namespace sandglass {

const Words<int>& axis_words() {
  static const Words<int> words = {{"x", 0}, {"y", 1}, {"z", 2}};
  return words;
}

const Words<Side>& side_words() {
  static const Words<Side> words = {{"periodic", Side::periodic}, {"specular", Side::specular}};
  return words;
}

const Words<ContactFactor>& contact_factor_words() {
  static const Words<ContactFactor> words = {{"none", ContactFactor::none}, {"local", ContactFactor::local}};
  return words;
}

const Words<DensityEstimate>& density_words() {
  static const Words<DensityEstimate> words = {{"smoothed", DensityEstimate::smoothed},
                                               {"cell", DensityEstimate::cell}};
  return words;
}

const Words<Offset>& offset_words() {
  static const Words<Offset> words = {{"none", Offset::none},
                                      {"consistent", Offset::consistent},
                                      {"corrected", Offset::corrected},
                                      {"random", Offset::random}};
  return words;
}

const Words<Positions>& positions_words() {
  static const Words<Positions> words = {{"random", Positions::random},
                                         {"lattice", Positions::lattice},
                                         {"random-without-overlap", Positions::random_without_overlap}};
  return words;
}

}  // namespace sandglass

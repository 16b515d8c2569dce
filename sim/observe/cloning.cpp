#include "sim/observe/cloning.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/axes.hpp"

namespace sandglass {

namespace {
struct Words {
  const char *name, *units, *summary;
};

Words words_of(std::size_t kind) {
  constexpr const char* units = "mass; mass length time^-1; mass length^2 time^-2";
  if (kind == 0)
    return {"cloning-brought", units,
            "mass, |momentum| and kinetic energy of who crosses into a region of lower weight (cloned) or "
            "higher (removed), since time zero"};
  if (kind == 1) return {"cloning-gained", units, "what its copies have more than it had, since time zero"};
  return {"cloning-variance", "mass^2; mass^2 length^2 time^-2; mass^2 length^4 time^-4",
          "variance of what is gained, the sum over crossings since time zero"};
}

std::vector<std::string> components(int dimension) {
  std::vector<std::string> names;
  for (const char* way : {"cloned-", "removed-"}) {
    names.push_back(std::string(way) + "mass");
    for (const std::string& axis : axis_names(dimension)) names.push_back(way + ("momentum-" + axis));
    names.push_back(std::string(way) + "energy");
  }
  return names;
}
}  // namespace

template <int D>
Quantity Cloning<D>::quantity() const {
  const Words words = words_of(kind_);
  return {words.name, words.units, words.summary, {2 * CloningSums<D>::kAmounts}, components(D), {}, ""};
}

template <int D>
void Cloning<D>::start(const View<D>& view) {
  if (view.tally->cloning.size() != CloningSums<D>::kSize)
    throw InputError(
        "the observer 'cloning' needs regions of other weights; give [[region]] or remove the observer");
}

template <int D>
std::vector<double> Cloning<D>::measure(const View<D>& view) {
  std::vector<double> values;
  const std::size_t first = CloningSums<D>::place(kind_, false, 0);
  for (std::size_t i = 0; i < 2 * CloningSums<D>::kAmounts; ++i)
    values.push_back(view.tally->cloning.at(first + i).value());
  return values;
}

template class Cloning<2>;
template class Cloning<3>;

}  // namespace sandglass

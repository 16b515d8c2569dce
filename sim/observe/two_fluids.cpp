#include "sim/observe/two_fluids.hpp"

#include "sim/observe/axes.hpp"
#include "sim/observe/bin_counts.hpp"
#include "sim/observe/sums.hpp"

namespace sandglass {

namespace {
const std::array<std::string, 2> kFluids = {"first", "others"};

std::size_t fluid_of(std::size_t species) { return species == 0 ? 0 : 1; }
}  // namespace

template <int D>
Quantity FluidDensity<D>::quantity() const {
  std::vector<std::size_t> shape = bins_.extents;
  shape.push_back(2);
  return {"fluid-density",
          "length^-D",
          "per bin: number density of the first species and of all others",
          shape,
          {},
          {},
          ""};
}

template <int D>
std::vector<double> FluidDensity<D>::measure(const View<D>& view) {
  return densities_by_bin(view, bins_, 2, fluid_of);
}

template <int D>
Quantity FluidCentre<D>::quantity() const {
  std::vector<std::string> names;
  for (const std::string& fluid : kFluids)
    for (int axis = 0; axis < D; ++axis) names.push_back(fluid + '-' + axis_name(axis));
  return {"fluid-centre",
          "length",
          "mean position of the first species and of all others",
          {2, D},
          names,
          {},
          ""};
}

template <int D>
std::vector<double> FluidCentre<D>::measure(const View<D>& view) {
  return with_population(view, [&](const auto& all) {
    const auto sums = sum_particles_by_kind<D + 1>(
        view, 2, [&](std::uint32_t i) { return fluid_of(all.index(i)); },
        [&](const Phase<D>& particle, std::uint32_t i) {
          std::array<double, D + 1> terms;
          for (int axis = 0; axis < D; ++axis)
            terms[static_cast<std::size_t>(axis)] = all.weight(i) * particle.position[axis];
          terms[D] = all.weight(i);
          return terms;
        });
    std::vector<double> values;
    for (const auto& sum : sums)
      for (std::size_t axis = 0; axis < D; ++axis) values.push_back(sum[D] > 0 ? sum[axis] / sum[D] : 0);
    return values;
  });
}

template <int D>
Quantity MixingIndex<D>::quantity() const {
  return {"mixing-index",
          "1",
          "Lacey's index over the bins: 0 separate fluids, 1 mixed at random",
          {},
          {},
          {},
          ""};
}

template <int D>
std::vector<double> MixingIndex<D>::measure(const View<D>& view) {
  const std::vector<double> counts = with_population(view, [&](const auto& all) {
    return sums_by_bin(
        view, bins_, 2, [&](std::uint32_t i) { return fluid_of(all.index(i)); },
        [](std::uint32_t) { return 1; });
  });
  std::vector<std::array<double, 2>> bins;
  for (std::size_t i = 0; i < counts.size(); i += 2) bins.push_back({counts[i], counts[i + 1]});
  return {mixing_index(bins)};
}

double mixing_index(const std::vector<std::array<double, 2>>& bins) {
  double first = 0, total = 0, occupied = 0, squares = 0;
  for (const auto& [one, other] : bins) {
    const double here = one + other;
    if (!(here > 0)) continue;
    first += one;
    total += here;
    occupied += 1;
    squares += one * one / here;
  }
  if (!(total > occupied) || first == 0 || first == total) return 0;
  const double p = first / total, separate = p * (1 - p);
  const double variance = squares / total - p * p;
  return (separate - variance) / (separate * (1 - (occupied - 1) / (total - 1)));
}

template class FluidDensity<2>;
template class FluidDensity<3>;
template class FluidCentre<2>;
template class FluidCentre<3>;
template class MixingIndex<2>;
template class MixingIndex<3>;

}  // namespace sandglass

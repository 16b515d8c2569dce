#include "sim/observe/two_fluids.hpp"

#include "sim/observe/axes.hpp"
#include "sim/observe/sums.hpp"

namespace sandglass {

namespace {
const std::array<std::string, 2> kFluids = {"first", "others"};

/// Sum of the weights, or the number of simulated particles, of each fluid in each bin.
template <int D>
std::vector<std::array<double, 2>> counts(const View<D>& view, const Lattice<D>& bins, bool weighted) {
  std::vector<std::array<double, 2>> all(bins.size());
  with_population(view, [&](const auto& population) {
    for (std::uint32_t i = 0; i < view.particles.size(); ++i)
      all[bins.bin_of(view.particles[i].position, view.box)][population.index(i) == 0 ? 0 : 1] +=
          weighted ? population.weight.unit * population.weight(i) : 1;
  });
  return all;
}
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
  const double per_bin = static_cast<double>(bins_.size()) / view.box.prod();
  std::vector<double> values;
  for (const auto& bin : counts(view, bins_, true))
    for (const double count : bin) values.push_back(count * per_bin);
  return values;
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
    const auto sum = sum_particles<2 * (D + 1)>(view, [&all](const Phase<D>& particle, std::uint32_t i) {
      std::array<double, 2 * (D + 1)> terms{};
      const std::size_t fluid = all.index(i) == 0 ? 0 : D + 1;
      for (int axis = 0; axis < D; ++axis)
        terms[fluid + static_cast<std::size_t>(axis)] = all.weight(i) * particle.position[axis];
      terms[fluid + D] = all.weight(i);
      return terms;
    });
    std::vector<double> values;
    for (const std::size_t fluid : {std::size_t{0}, std::size_t{D + 1}})
      for (std::size_t axis = 0; axis < D; ++axis)
        values.push_back(sum[fluid + D] > 0 ? sum[fluid + axis] / sum[fluid + D] : 0);
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
  return {mixing_index(counts(view, bins_, false))};
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

#include "sim/observe/pair_correlation.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/pairs.hpp"

#include <cmath>

#include <fmt/format.h>

namespace sandglass {

double shell_volume(int dimension, double inner, double outer) {
  if (dimension == 2) return M_PI * (outer - inner) * (outer + inner);
  return 4 * M_PI / 3 * (outer - inner) * (outer * outer + outer * inner + inner * inner);
}

template <int D>
PairCorrelation<D>::PairCorrelation(const ObserverSpec& spec) : spec_(spec) {
  const auto [low, high] = spec.range;
  if (!(low >= 0 && low < high && std::isfinite(high)))
    throw InputError(
        fmt::format("'observe.range' of the observer 'pair-correlation' goes from {} to {}; give "
                    "two rising distances, the first not below 0",
                    low, high));
}

template <int D>
Quantity PairCorrelation<D>::quantity() const {
  return {"pair-correlation", "1", "pair correlation g(r)", {spec_.bins}, {}, bin_edges(spec_),
          "distance [length]"};
}

template <int D>
void PairCorrelation<D>::start(const View<D>& view) {
  if (view.particles.size() < 2)
    throw InputError(
        "the observer 'pair-correlation' needs at least 2 particles; remove it, or add particles");
  if (!view.columns.get(column::weight).empty())
    throw InputError(
        "the observer 'pair-correlation' counts particles, and here each stands for another number of real "
        "ones; remove it");
  const double most = view.box.minCoeff() / 2;
  if (spec_.range[1] > most)
    throw InputError(
        fmt::format("'observe.range' of the observer 'pair-correlation' goes to {}; at most half "
                    "the shortest edge of the domain, {}, is allowed",
                    spec_.range[1], most));
}

template <int D>
std::vector<double> PairCorrelation<D>::measure(const View<D>& view) {
  const auto [low, high] = spec_.range;
  const double per_bin = static_cast<double>(spec_.bins) / (high - low);
  std::vector<std::uint64_t> pairs(spec_.bins);
  // The root may round up to the far edge.
  const auto last = static_cast<double>(spec_.bins) - 0.5;
  for_each_pair<D>(view.particles, view.box, high, [&, low = low](double square) {
    const double bin = (std::sqrt(square) - low) * per_bin;
    if (bin >= 0) ++pairs[static_cast<std::size_t>(std::min(bin, last))];
  });
  const std::vector<double> edges = bin_edges(spec_);
  const auto count = static_cast<double>(view.particles.size());
  const double pairs_per_volume = count * (count - 1) / 2 / view.box.prod();
  std::vector<double> values(spec_.bins);
  for (std::size_t i = 0; i < spec_.bins; ++i)
    values[i] = static_cast<double>(pairs[i]) / (pairs_per_volume * shell_volume(D, edges[i], edges[i + 1]));
  return values;
}

template class PairCorrelation<2>;
template class PairCorrelation<3>;

}  // namespace sandglass

#include "sim/observe/pair_correlation.hpp"

#include "sim/observe/pairs.hpp"

#include <cmath>

namespace sandglass {

double shell_volume(int dimension, double inner, double outer) {
  if (dimension == 2) return M_PI * (outer - inner) * (outer + inner);
  return 4 * M_PI / 3 * (outer - inner) * (outer * outer + outer * inner + inner * inner);
}

template <int D>
Quantity PairCorrelation<D>::quantity() const {
  return {"pair-correlation", "1", "pair correlation g(r)", {spec_.bins}, {}, bin_edges(spec_),
          "distance [length]"};
}

template <int D>
void PairCorrelation<D>::start(const View<D>& view) {
  shells_.require(view);
}

template <int D>
std::vector<double> PairCorrelation<D>::measure(const View<D>& view) {
  std::vector<std::uint64_t> pairs(spec_.bins);
  for_each_pair<D>(view.particles, view.box, shells_.reach(),
                   [&](const Vector<D>&, double square, std::uint32_t, std::uint32_t) {
                     if (const auto shell = shells_.shell_of(square)) ++pairs[*shell];
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

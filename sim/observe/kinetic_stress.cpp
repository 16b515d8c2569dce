#include "sim/observe/kinetic_stress.hpp"

#include "sim/observe/axes.hpp"
#include "sim/observe/bin_sums.hpp"
#include "sim/observe/population.hpp"

namespace sandglass {

namespace {
template <int D>
constexpr std::size_t kComponents = D*(D + 1) / 2;

/// What the particles of one bin add up to.
template <int D>
struct Bin : BinSums {
  Vector<D> momentum = Vector<D>::Zero();
  std::array<double, kComponents<D>> products{};  ///< of the components of C, times mass

  void add_products(const Vector<D>& relative, double weighted_mass) {
    std::size_t k = 0;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) products[k++] += weighted_mass * relative[a] * relative[b];
  }
};

template <int D>
std::string component_names() {
  std::string names;
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b) names += (names.empty() ? "" : ", ") + axis_name(a) + axis_name(b);
  return names;
}
}  // namespace

template <int D>
Quantity KineticStress<D>::quantity() const {
  std::vector<std::size_t> shape = bins_.extents;
  shape.push_back(kComponents<D>);
  return {"kinetic-stress",
          D == 2 ? "mass time^-2" : "mass length^-1 time^-2",
          "per bin: kinetic pressure tensor n m <C C>, components " + component_names<D>(),
          shape,
          {},
          {},
          ""};
}

template <int D>
template <class All>
std::vector<double> KineticStress<D>::measure(const View<D>& view, const All& all) const {
  std::vector<Bin<D>> bins(bins_.size());
  const auto bin_of = [&](std::uint32_t i) -> Bin<D>& {
    return bins[bins_.bin_of(view.particles[i].position, view.box)];
  };
  for (std::uint32_t i = 0; i < view.particles.size(); ++i) {
    Bin<D>& bin = bin_of(i);
    bin.add(all, i);
    bin.momentum += all.real_mass(i) * view.particles[i].velocity;
  }
  for (std::uint32_t i = 0; i < view.particles.size(); ++i) {
    Bin<D>& bin = bin_of(i);
    bin.add_products(view.particles[i].velocity - bin.momentum / bin.mass, all.real_mass(i));
  }
  const double per_volume = all.real_unit() * static_cast<double>(bins.size()) / view.box.prod();
  std::vector<double> values;
  values.reserve(bins.size() * kComponents<D>);
  for (const Bin<D>& bin : bins) {
    const double freedom = bin.particles > 1 ? 1 - bin.shared / (bin.mass * bin.count) : 1;
    for (const double product : bin.products)
      values.push_back(bin.particles > 1 ? per_volume * product / freedom : 0);
  }
  return values;
}

template <int D>
std::vector<double> KineticStress<D>::measure(const View<D>& view) {
  return with_population(view, [&](const auto& all) { return measure(view, all); });
}

template class KineticStress<2>;
template class KineticStress<3>;

}  // namespace sandglass

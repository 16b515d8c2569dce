#include "sim/observe/energy.hpp"

#include "sim/observe/axes.hpp"
#include "sim/observe/sums.hpp"

#include <cmath>

namespace sandglass {

namespace {
constexpr const char* kEnergyUnits = "mass length^2 time^-2";
constexpr const char* kMomentumUnits = "mass length time^-1";
}  // namespace

template <int D>
Quantity Energy<D>::quantity() const {
  return {"energy", kEnergyUnits, "kinetic energy of all real particles", {}, {}, {}, ""};
}

template <int D>
std::vector<double> Energy<D>::measure(const View<D>& view) {
  return with_population(view, [&view](const auto& all) {
    const auto sum = sum_particles<1>(view, [&all](const Phase<D>& particle, std::uint32_t i) {
      return std::array{all.real_mass(i) * particle.velocity.squaredNorm()};
    });
    return std::vector{0.5 * all.real_unit() * sum[0]};
  });
}

template <int D>
Quantity Temperature<D>::quantity() const {
  auto components = axis_names(D);
  components.push_back("total");
  return {"temperature",
          kEnergyUnits,
          "granular temperature along each axis and their mean",
          {components.size()},
          components,
          {},
          ""};
}

template <int D>
std::vector<double> Temperature<D>::measure(const View<D>& view) {
  const Vector<D> temperature = temperatures(view);
  std::vector<double> values(temperature.data(), temperature.data() + D);
  values.push_back(temperature.mean());
  return values;
}

template <int D>
Quantity Momentum<D>::quantity() const {
  return {"momentum", kMomentumUnits, "total momentum of the real particles", {D}, axis_names(D), {}, ""};
}

template <int D>
std::vector<double> Momentum<D>::measure(const View<D>& view) {
  const Vector<D> momentum = with_population(view, [&view](const auto& all) -> Vector<D> {
    return all.real_unit() * all.total_mass * mean_velocity(view, all);
  });
  return {momentum.data(), momentum.data() + D};
}

template <int D>
Quantity MomentumScale<D>::quantity() const {
  return {"momentum-scale", kMomentumUnits, "sum of the magnitudes of all momenta", {}, {}, {}, ""};
}

template <int D>
std::vector<double> MomentumScale<D>::measure(const View<D>& view) {
  return with_population(view, [&view](const auto& all) {
    const auto sum = sum_particles<1>(view, [&all](const Phase<D>& particle, std::uint32_t i) {
      return std::array{all.real_mass(i) * particle.velocity.norm()};
    });
    return std::vector{all.real_unit() * sum[0]};
  });
}

template class Energy<2>;
template class Energy<3>;
template class Temperature<2>;
template class Temperature<3>;
template class Momentum<2>;
template class Momentum<3>;
template class MomentumScale<2>;
template class MomentumScale<3>;

}  // namespace sandglass

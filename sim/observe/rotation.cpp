#include "sim/observe/rotation.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/sums.hpp"

namespace sandglass {

namespace {
constexpr const char* kEnergyUnits = "mass length^2 time^-2";

/// Sum of I w^2 over the real particles, in their unit.
template <int D, class All>
double twice_energy(const View<D>& view, const All& all) {
  const auto spins = view.columns.get(column::spin<D>);
  return all.inertia_unit() * sum_particles<1>(view, [&](const Phase<D>&, std::uint32_t i) {
           return std::array{all.weight(i) * all.inertia(i) * spins[i].squaredNorm()};
         })[0];
}

}  // namespace

template <int D>
void require_spins(const View<D>& view, const std::string& observer) {
  if (!view.particles.empty() && view.columns.get(column::spin<D>).empty())
    throw InputError("the observer '" + observer +
                     "' needs particles that spin; give a species 'tangential-restitution' or remove the "
                     "observer");
}

template <int D>
Quantity RotationalEnergy<D>::quantity() const {
  return {"rotational-energy", kEnergyUnits, "rotational energy of all real particles", {}, {}, {}, ""};
}

template <int D>
void RotationalEnergy<D>::start(const View<D>& view) {
  require_spins(view, "rotational-energy");
}

template <int D>
std::vector<double> RotationalEnergy<D>::measure(const View<D>& view) {
  return with_population(view, [&view](const auto& all) {
    return std::vector{0.5 * all.weight.unit * twice_energy(view, all)};
  });
}

template <int D>
Quantity RotationalTemperature<D>::quantity() const {
  return {"rotational-temperature", kEnergyUnits, "rotational granular temperature", {}, {}, {}, ""};
}

template <int D>
void RotationalTemperature<D>::start(const View<D>& view) {
  require_spins(view, "rotational-energy");
}

template <int D>
std::vector<double> RotationalTemperature<D>::measure(const View<D>& view) {
  constexpr double freedom = Spin<D>::RowsAtCompileTime;
  return with_population(view, [&view](const auto& all) {
    return std::vector{all.count > 0 ? twice_energy(view, all) / (freedom * all.count) : 0};
  });
}

template void require_spins(const View<2>&, const std::string&);
template void require_spins(const View<3>&, const std::string&);
template class RotationalEnergy<2>;
template class RotationalEnergy<3>;
template class RotationalTemperature<2>;
template class RotationalTemperature<3>;

}  // namespace sandglass

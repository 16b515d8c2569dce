#include "sim/observe/centre_of_mass.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/axes.hpp"
#include "sim/observe/sums.hpp"

namespace sandglass {

template <int D>
CentreOfMass<D>::CentreOfMass(const ObserverSpec& spec) : axes_(spec.bounded) {
  if (axes_.empty())
    throw InputError(
        "the observer 'centre-of-mass' needs an axis that is not periodic; put walls there "
        "('domain.sides') or remove the observer");
}

template <int D>
Quantity CentreOfMass<D>::quantity() const {
  std::vector<std::string> names;
  for (const int axis : axes_) names.push_back(axis_name(axis));
  return {"centre-of-mass",
          "length",
          "position of the centre of mass along each axis that is not periodic",
          {names.size()},
          names,
          {},
          ""};
}

template <int D>
std::vector<double> CentreOfMass<D>::measure(const View<D>& view) {
  if (view.particles.empty()) return {};
  return with_population(view, [&](const auto& all) {
    const auto sum = sum_particles<D>(view, [&all](const Phase<D>& particle, std::uint32_t i) {
      std::array<double, D> moment;
      for (int axis = 0; axis < D; ++axis)
        moment[static_cast<std::size_t>(axis)] = all.real_mass(i) * particle.position[axis];
      return moment;
    });
    std::vector<double> centre;
    for (const int axis : axes_) centre.push_back(sum[static_cast<std::size_t>(axis)] / all.total_mass);
    return centre;
  });
}

template class CentreOfMass<2>;
template class CentreOfMass<3>;

}  // namespace sandglass

#include "sim/observe/distribution.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/axes.hpp"
#include "sim/observe/sums.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass {

namespace {
/// x, x^2, x^3, x^4 of a square give the even powers to order 8.
std::array<double, 4> powers(double square) {
  return {square, square * square, square * square * square, square * square * square * square};
}
}  // namespace

template <int D>
Quantity Moments<D>::quantity() const {
  return {"moments",
          "1",
          "even velocity moments relative to the second: one component (m) and the speed (s)",
          {7},
          {"m2", "m4", "m6", "m8", "s4", "s6", "s8"},
          {},
          ""};
}

template <int D>
void Moments<D>::start(const View<D>& view) {
  if (view.particles.size() < 2)
    throw InputError("the observer 'moments' needs at least 2 particles; remove it, or add particles");
}

namespace {
/// Sums over real particles: 4 powers of each component of sqrt(m) C, then 4 of its length.
template <int D, class All>
std::array<double, 4 * (D + 1)> sum_powers(const View<D>& view, const All& all) {
  const Vector<D> mean = mean_velocity(view, all);
  return sum_particles<4 * (D + 1)>(view, [&](const Phase<D>& particle, std::uint32_t i) {
    std::array<double, 4 * (D + 1)> terms;
    const Vector<D> relative = particle.velocity - mean;
    for (int axis = 0; axis < D; ++axis)
      std::ranges::copy(powers(all.mass(i) * relative[axis] * relative[axis]), terms.begin() + 4 * axis);
    std::ranges::copy(powers(all.mass(i) * relative.squaredNorm()), terms.begin() + 4 * D);
    for (double& term : terms) term *= all.weight(i);
    return terms;
  });
}

template <int D>
void require_motion(const std::array<double, 4 * (D + 1)>& sum) {
  for (int axis = 0; axis < D; ++axis)
    if (sum[static_cast<std::size_t>(4 * axis)] == 0)
      throw RunError("'moments' are not defined: no particle moves relative to the mean along " +
                     axis_name(axis) + "; remove the observer 'moments'");
}

template <int D>
std::vector<double> moments_of(const std::array<double, 4 * (D + 1)>& sum, double count) {
  const auto moment = [&](int group, int order) {
    return sum[static_cast<std::size_t>(4 * group + order - 1)] / count /
           std::pow(sum[static_cast<std::size_t>(4 * group)] / count, order);
  };
  std::vector<double> values;
  for (int order = 1; order <= 4; ++order) {
    double component = 0;
    for (int axis = 0; axis < D; ++axis) component += moment(axis, order) / D;
    values.push_back(component);
  }
  for (int order = 2; order <= 4; ++order) values.push_back(moment(D, order));
  return values;
}
}  // namespace

template <int D>
std::vector<double> Moments<D>::measure(const View<D>& view) {
  return with_population(view, [&view](const auto& all) {
    const auto sum = sum_powers(view, all);
    require_motion<D>(sum);
    return moments_of<D>(sum, all.count);
  });
}

template <int D>
Quantity VelocityHistogram<D>::quantity() const {
  return {"velocity-histogram-" + axis_name(spec_.axis),
          "particles",
          "particles by one velocity component",
          {spec_.bins},
          {},
          bin_edges(spec_),
          "velocity " + axis_name(spec_.axis) + " [length/time]"};
}

template <int D>
std::vector<double> VelocityHistogram<D>::measure(const View<D>& view) {
  const double per_bin = static_cast<double>(spec_.bins) / (spec_.range[1] - spec_.range[0]);
  const double last = static_cast<double>(spec_.bins) - 0.5;
  return with_population(view, [&](const auto& all) {
    std::vector<double> counts(spec_.bins);
    for (std::uint32_t i = 0; i < view.particles.size(); ++i) {
      const double bin = (view.particles[i].velocity[spec_.axis] - spec_.range[0]) * per_bin;
      counts[static_cast<std::size_t>(std::clamp(bin, 0.0, last))] += all.weight(i);
    }
    return counts;
  });
}

template <int D>
Quantity ShearMode<D>::quantity() const {
  return {cosine_ ? "shear-mode-cos" : "shear-mode",
          "length time^-1",
          cosine_ ? "cosine amplitude of the shear wave" : "sine amplitude of the shear wave",
          {},
          {},
          {},
          ""};
}

template <int D>
std::vector<double> ShearMode<D>::measure(const View<D>& view) {
  const double wavenumber = 2 * M_PI * periods_ / view.box[1];
  return with_population(view, [&](const auto& all) {
    const auto sum = sum_particles<1>(view, [&](const Phase<D>& particle, std::uint32_t i) {
      const double phase = wavenumber * particle.position[1];
      return std::array{all.real_mass(i) * particle.velocity[0] *
                        (cosine_ ? std::cos(phase) : std::sin(phase))};
    });
    return std::vector{view.particles.empty() ? 0 : 2 * sum[0] / all.total_mass};
  });
}

template class Moments<2>;
template class Moments<3>;
template class VelocityHistogram<2>;
template class VelocityHistogram<3>;
template class ShearMode<2>;
template class ShearMode<3>;

}  // namespace sandglass

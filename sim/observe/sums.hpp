#pragma once

#include "sim/base/exact_sum.hpp"
#include "sim/observe/view.hpp"

#include <array>

namespace sandglass {

/// Sum of `term(particle)` over all particles: plain within a cell, exact over cells, so that the result depends neither
/// on the order of the cells nor on how they are shared out.
template <std::size_t K, int D, class Term>
std::array<double, K> sum_particles(const View<D>& view, Term term) {
  std::array<ExactSum, K> total;
  for (std::size_t cell = 0; cell + 1 < view.offsets.size(); ++cell) {
    if (view.offsets[cell] == view.offsets[cell + 1]) continue;
    std::array<double, K> partial{};
    for (std::uint32_t i = view.offsets[cell]; i < view.offsets[cell + 1]; ++i) {
      const std::array<double, K> value = term(view.particles[i]);
      for (std::size_t k = 0; k < K; ++k) partial[k] += value[k];
    }
    for (std::size_t k = 0; k < K; ++k) total[k].add(partial[k]);
  }
  std::array<double, K> sum;
  for (std::size_t k = 0; k < K; ++k) sum[k] = total[k].value();
  return sum;
}

template <int D>
Vector<D> mean_velocity(const View<D>& view) {
  const auto sum = sum_particles<D>(view, [](const Phase<D>& particle) {
    std::array<double, D> velocity;
    for (int axis = 0; axis < D; ++axis) velocity[static_cast<std::size_t>(axis)] = particle.velocity[axis];
    return velocity;
  });
  Vector<D> mean;
  for (int axis = 0; axis < D; ++axis)
    mean[axis] = sum[static_cast<std::size_t>(axis)] / static_cast<double>(view.particles.size());
  return mean;
}

/// Granular temperature m<C_i^2> along each axis, C relative to the mean velocity, N - 1 degrees of freedom per axis.
template <int D>
Vector<D> temperatures(const View<D>& view) {
  const Vector<D> mean = mean_velocity(view);
  const auto sum = sum_particles<D>(view, [&mean](const Phase<D>& particle) {
    std::array<double, D> square;
    for (int axis = 0; axis < D; ++axis) {
      const double relative = particle.velocity[axis] - mean[axis];
      square[static_cast<std::size_t>(axis)] = relative * relative;
    }
    return square;
  });
  Vector<D> temperature;
  for (int axis = 0; axis < D; ++axis)
    temperature[axis] =
        view.mass * sum[static_cast<std::size_t>(axis)] / (static_cast<double>(view.particles.size()) - 1);
  return temperature;
}

}  // namespace sandglass

#pragma once

#include "sim/observe/population.hpp"

#include <array>
#include <span>
#include <type_traits>
#include <vector>

namespace sandglass {

/// Of registers that each rank has filled for itself: the sums, on all ranks.
void add_over_ranks(Communicator& ranks, std::span<ExactSum> sums);

/// Sum of `term(particle)`, or of `term(particle, index)`, over all particles: plain within a cell, exact over cells, so
/// that the result depends neither on the order of the cells nor on how they are shared out.
template <std::size_t K, int D, class Term>
std::array<double, K> sum_particles(const View<D>& view, Term term) {
  std::array<ExactSum, K> total;
  for (std::size_t cell = 0; cell + 1 < view.offsets.size(); ++cell) {
    if (view.offsets[cell] == view.offsets[cell + 1]) continue;
    std::array<double, K> partial{};
    for (std::uint32_t i = view.offsets[cell]; i < view.offsets[cell + 1]; ++i) {
      std::array<double, K> value;
      if constexpr (std::is_invocable_v<Term, const Phase<D>&>)
        value = term(view.particles[i]);
      else
        value = term(view.particles[i], i);
      for (std::size_t k = 0; k < K; ++k) partial[k] += value[k];
    }
    for (std::size_t k = 0; k < K; ++k) total[k].add(partial[k]);
  }
  if (view.ranks != nullptr) add_over_ranks(*view.ranks, total);
  std::array<double, K> sum;
  for (std::size_t k = 0; k < K; ++k) sum[k] = total[k].value();
  return sum;
}

/// The same for the particles of each kind by themselves, in one pass: `kind(i)` is below `kinds`.
template <std::size_t K, int D, class Kind, class Term>
std::vector<std::array<double, K>> sum_particles_by_kind(const View<D>& view, std::size_t kinds, Kind kind,
                                                         Term term) {
  std::vector<std::array<ExactSum, K>> total(kinds);
  std::vector<std::array<double, K>> sums(kinds);
  for (std::size_t cell = 0; cell + 1 < view.offsets.size(); ++cell) {
    if (view.offsets[cell] == view.offsets[cell + 1]) continue;
    std::fill(sums.begin(), sums.end(), std::array<double, K>{});
    for (std::uint32_t i = view.offsets[cell]; i < view.offsets[cell + 1]; ++i) {
      const std::array<double, K> value = term(view.particles[i], i);
      for (std::size_t k = 0; k < K; ++k) sums[kind(i)][k] += value[k];
    }
    for (std::size_t each = 0; each < kinds; ++each)
      for (std::size_t k = 0; k < K; ++k) total[each][k].add(sums[each][k]);
  }
  for (std::size_t each = 0; each < kinds; ++each)
    for (std::size_t k = 0; k < K; ++k) sums[each][k] = total[each][k].value();
  return sums;
}

/// Velocity of the centre of mass; zero without particles.
template <int D, class All>
Vector<D> mean_velocity(const View<D>& view, const All& all) {
  const auto sum = sum_particles<D>(view, [&all](const Phase<D>& particle, std::uint32_t i) {
    std::array<double, D> momentum;
    for (int axis = 0; axis < D; ++axis)
      momentum[static_cast<std::size_t>(axis)] = all.real_mass(i) * particle.velocity[axis];
    return momentum;
  });
  Vector<D> mean = Vector<D>::Zero();
  if (all.count == 0) return mean;
  for (int axis = 0; axis < D; ++axis) mean[axis] = sum[static_cast<std::size_t>(axis)] / all.total_mass;
  return mean;
}

template <int D>
Vector<D> mean_velocity(const View<D>& view) {
  return with_population(view, [&view](const auto& all) { return mean_velocity(view, all); });
}

template <int D, class All>
Vector<D> temperatures(const View<D>& view, const All& all) {
  const Vector<D> mean = mean_velocity(view, all);
  const auto sum = sum_particles<D>(view, [&](const Phase<D>& particle, std::uint32_t i) {
    std::array<double, D> square;
    for (int axis = 0; axis < D; ++axis) {
      const double relative = particle.velocity[axis] - mean[axis];
      square[static_cast<std::size_t>(axis)] = all.real_mass(i) * relative * relative;
    }
    return square;
  });
  Vector<D> temperature;
  for (int axis = 0; axis < D; ++axis)
    temperature[axis] = all.mass_unit() * sum[static_cast<std::size_t>(axis)] / all.freedom;
  return temperature;
}

/// Granular temperature <m C_i^2> of the real particles along each axis, C relative to the velocity of the centre of mass,
/// with Population::freedom degrees of freedom: N - 1 of alike weights, without bias for a mixture too, since
/// sum m_i <C_i^2> = N T - T. One particle has temperature 0.
template <int D>
Vector<D> temperatures(const View<D>& view) {
  return with_population(view, [&view](const auto& all) { return temperatures(view, all); });
}

}  // namespace sandglass

#include "sim/method/mixing/pair_forces.hpp"

#include <array>
#include <cmath>

namespace sandglass::mixing {

namespace {
/// Half of the cells around one, so that each pair of cells comes once: columns and rows ahead.
constexpr std::array<std::array<int, 2>, 4> kAhead = {{{1, 0}, {-1, 1}, {0, 1}, {1, 1}}};

class Pairs {
 public:
  Pairs(const Repulsion& repulsion, const Crowd& crowd, std::span<Vector<2>> accelerations)
      : repulsion_(repulsion), crowd_(crowd), accelerations_(accelerations) {}

  void within(std::uint32_t cell) {
    for (std::uint32_t i = crowd_.offsets[cell]; i < crowd_.offsets[cell + 1]; ++i)
      for (std::uint32_t j = i + 1; j < crowd_.offsets[cell + 1]; ++j) push(i, j);
  }
  void between(std::uint32_t cell, std::uint32_t other) {
    for (std::uint32_t i = crowd_.offsets[cell]; i < crowd_.offsets[cell + 1]; ++i)
      for (std::uint32_t j = crowd_.offsets[other]; j < crowd_.offsets[other + 1]; ++j) push(i, j);
  }
  std::uint64_t count() const { return count_; }

 private:
  void push(std::uint32_t i, std::uint32_t j) {
    const Vector<2> separation = crowd_.particles[i].position - crowd_.particles[j].position;
    const double distance = std::sqrt(separation.squaredNorm());
    if (!(distance < repulsion_.cutoff)) return;
    const Vector<2> push = repulsion_.per_separation(distance) * separation;
    accelerations_[i] += crowd_.masses[j] * push;
    accelerations_[j] -= crowd_.masses[i] * push;
    ++count_;
  }

  const Repulsion& repulsion_;
  const Crowd& crowd_;
  std::span<Vector<2>> accelerations_;
  std::uint64_t count_ = 0;
};
}  // namespace

PairForces::PairForces(const Repulsion& repulsion, const Grid<2>& grid)
    : repulsion_(repulsion), columns_(grid.cells(0)), rows_(grid.cells(1)) {}

std::uint64_t PairForces::add(const Crowd& crowd, std::span<Vector<2>> accelerations) const {
  Pairs pairs(repulsion_, crowd, accelerations);
  for (std::uint32_t row = 0; row < rows_; ++row)
    for (std::uint32_t column = 0; column < columns_; ++column) {
      const std::uint32_t cell = row * columns_ + column;
      pairs.within(cell);
      for (const auto& [right, up] : kAhead) {
        const std::int64_t x = std::int64_t{column} + right, y = std::int64_t{row} + up;
        if (x < 0 || x >= columns_ || y >= rows_) continue;
        pairs.between(cell, static_cast<std::uint32_t>(y * columns_ + x));
      }
    }
  return pairs.count();
}

}  // namespace sandglass::mixing

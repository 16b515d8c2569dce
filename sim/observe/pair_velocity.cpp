#include "sim/observe/pair_velocity.hpp"

#include "sim/observe/pairs.hpp"
#include "sim/observe/sums.hpp"

namespace sandglass {

template <int D>
Quantity PairVelocity<D>::quantity() const {
  const std::string name = component_ == Component::parallel ? "parallel" : "transverse";
  return {"pair-velocity-" + name,
          "length^2 time^-2",
          "mean product of the velocities of two particles, component " + name + " to their separation",
          {spec_.bins},
          {},
          bin_edges(spec_),
          "distance [length]"};
}

template <int D>
void PairVelocity<D>::start(const View<D>& view) {
  shells_.require(view);
}

template <int D>
std::vector<double> PairVelocity<D>::measure(const View<D>& view) {
  struct Shell {
    double sum = 0;
    std::uint64_t pairs = 0;
  };
  const Vector<D> mean = mean_velocity(view);
  std::vector<Shell> sums(shells_.size());
  for_each_pair<D>(view.particles, view.box, shells_.reach(),
                   [&](const Vector<D>& separation, double square, std::uint32_t i, std::uint32_t j) {
                     const auto shell = shells_.shell_of(square);
                     if (!shell || square == 0) return;
                     const Vector<D> one = view.particles[i].velocity - mean;
                     const Vector<D> two = view.particles[j].velocity - mean;
                     const double along = one.dot(separation) * two.dot(separation) / square;
                     sums[*shell].sum +=
                         component_ == Component::parallel ? along : (one.dot(two) - along) / (D - 1);
                     ++sums[*shell].pairs;
                   });
  std::vector<double> values;
  for (const Shell& shell : sums)
    values.push_back(shell.pairs > 0 ? shell.sum / static_cast<double>(shell.pairs) : 0);
  return values;
}

template class PairVelocity<2>;
template class PairVelocity<3>;

}  // namespace sandglass

#include "sim/observe/fields.hpp"

#include "sim/observe/bin_sums.hpp"
#include "sim/observe/population.hpp"

namespace sandglass {

template <int D>
Quantity Fields<D>::quantity() const {
  std::vector<std::size_t> shape = bins_.extents;
  shape.push_back(D + 2);
  return {"fields",
          "length^-D; length time^-1; mass length^2 time^-2",
          "per bin, those along the last axis one after the other: number density, mean velocity, granular "
          "temperature",
          shape,
          {},
          {},
          ""};
}

template <int D>
template <class All>
std::vector<double> Fields<D>::measure(const View<D>& view, const All& all) const {
  struct Sums : BinSums {
    Vector<D> mean = Vector<D>::Zero();
    double squares = 0;  ///< of the velocity relative to the mean (Welford 1962; with masses: West 1979)
  };
  std::vector<Sums> sums(bins_.size());
  for (std::uint32_t i = 0; i < view.particles.size(); ++i) {
    const Phase<D>& particle = view.particles[i];
    Sums& bin = sums[bins_.bin_of(particle.position, view.box)];
    const Vector<D> before = particle.velocity - bin.mean;
    bin.add(all, i);
    bin.mean += all.real_mass(i) * before / bin.mass;
    bin.squares += all.real_mass(i) * before.dot(particle.velocity - bin.mean);
  }
  const double density = all.weight.unit * static_cast<double>(sums.size()) / view.box.prod();
  std::vector<double> values;
  values.reserve(sums.size() * (D + 2));
  for (const Sums& bin : sums) {
    values.push_back(density * bin.count);
    values.insert(values.end(), bin.mean.data(), bin.mean.data() + D);
    const double freedom = D * (bin.count - bin.shared / bin.mass);
    values.push_back(bin.particles > 1 ? all.mass_unit() * bin.squares / freedom : 0);
  }
  return values;
}

template <int D>
std::vector<double> Fields<D>::measure(const View<D>& view) {
  return with_population(view, [&](const auto& all) { return measure(view, all); });
}

template class Fields<2>;
template class Fields<3>;

}  // namespace sandglass

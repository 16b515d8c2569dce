#include "sim/method/dsmc/test_gas.hpp"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

namespace sandglass::dsmc {
namespace {

template <int D>
void scan(double fraction, double per_cell, double edge, double restitution, double dtc) {
  Parameters parameters = gas_with_offset<D>(fraction, per_cell);
  parameters.offset = {};
  parameters.partners = Partners::contact;
  parameters.restitution = restitution;
  parameters.weight = fraction / particle_volume(D, 1) * std::pow(edge, D) / per_cell;
  const auto cells = static_cast<std::uint32_t>(std::lround(std::pow(15'000 / per_cell, 1.0 / D)));
  const Grid<D> grid = cubic_grid<D>(cells, edge);
  const auto count = static_cast<std::size_t>(per_cell * grid.size());
  Dsmc<D> dsmc(grid, parameters, {}, {});
  dsmc.assign({maxwellian<D>(count, cells * edge), {}});
  const double density = fraction / particle_volume(D, 1), contact = contact_formula(D)(fraction).value;
  const double rate = (D == 2 ? 2 : 4) * std::sqrt(M_PI) * density * contact, dt = dtc / rate;
  std::uint64_t step = 0;
  std::vector<double> rates, pressures;
  const double n = static_cast<double>(count);
  double temperature = 1, before_transfer = 0;
  const auto warm = static_cast<std::uint64_t>(5 / dtc), steps = static_cast<std::uint64_t>(400 / dtc);
  while (step < warm + steps) {
    const auto before = dsmc.tally().collisions;
    before_transfer = dsmc.tally().transfer.value();
    double square = 0;
    if (restitution < 1) {
      for (const Phase<D>& p : dsmc.view().particles) square += p.velocity.squaredNorm();
      temperature = square / (D * n);
    }
    dsmc.step(dt / std::sqrt(temperature), step++);
    if (step < warm) continue;
    double t2 = temperature;
    if (restitution < 1) {
      square = 0;
      for (const Phase<D>& p : dsmc.view().particles) square += p.velocity.squaredNorm();
      t2 = std::sqrt(temperature * square / (D * n));
    }
    rates.push_back(2 * static_cast<double>(dsmc.tally().collisions - before) / n / dtc - 1);
    pressures.push_back((dsmc.tally().transfer.value() - before_transfer) /
                            (D * n * t2 * dt / std::sqrt(temperature)) /
                            (std::exp2(D - 1) * fraction * contact * (1 + restitution) / 2) -
                        1);
  }
  const Mean r = mean_of_correlated(rates), p = mean_of_correlated(pressures);
  std::printf(
      "%dD nu %.2f per cell %4.0f edge %.2f weight %.4f r %.1f dt %.2f: rate %+.4f+-%.4f pressure "
      "%+.4f+-%.4f cand %.1f raised\n",
      D, fraction, per_cell, edge, parameters.weight, restitution, dtc, r.value, r.standard_error, p.value,
      p.standard_error, double(dsmc.tally().candidates) / double(dsmc.tally().collisions));
}

TEST(Scan, DISABLED_scan) {
  const double nu = std::atof(std::getenv("NU")), per = std::atof(std::getenv("PER")),
               edge = std::atof(std::getenv("EDGE")), r = std::atof(std::getenv("R")),
               dtc = std::atof(std::getenv("DTC"));
  scan<2>(nu, per, edge, r, dtc);
  scan<3>(nu, per, edge, r, dtc);
}

}  // namespace
}  // namespace sandglass::dsmc

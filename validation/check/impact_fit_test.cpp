#include "validation/check/impact_fit.hpp"

#include "sim/base/error.hpp"
#include "validation/law/impact.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::impact_fit_test {
namespace {

struct Impacts {
  std::vector<double> edges, counts;
};

Impacts drawn(int dimension, double c, int collisions, std::mt19937_64& generator) {
  constexpr int bins = 20;
  Impacts impacts;
  const double low = dimension == 2 ? -1 : 0, width = (1 - low) / bins;
  for (int i = 0; i <= bins; ++i) impacts.edges.push_back(low + i * width);
  impacts.counts.assign(bins, 0.0);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < collisions; ++i) {
    const double b = law::impact_quantile(dimension, c, share(generator));
    ++impacts.counts[std::min<std::size_t>(bins - 1, static_cast<std::size_t>((b - low) / width))];
  }
  return impacts;
}

TEST(ImpactFit, ErrorsAreThoseOfManyFits) {
  std::mt19937_64 generator(1);
  constexpr int runs = 300;
  for (int dimension : {2, 3})
    for (double c : {-1.5, 0.0, 0.4, 0.9}) {
      double spread = 0;
      for (int run = 0; run < runs; ++run) {
        const Impacts impacts = drawn(dimension, c, 4000, generator);
        const Mean fit = fit_impact_coefficient(dimension, impacts.edges, impacts.counts);
        spread += std::pow((fit.value - c) / fit.standard_error, 2) / runs;
      }
      EXPECT_NEAR(spread, 1, 5 * std::sqrt(2.0 / runs)) << dimension << " " << c;
    }
}

TEST(ImpactFit, RefusesWhatTheFormCannotDescribe) {
  const std::vector<double> edges{-1, 0, 1}, none{0, 0};
  EXPECT_THROW(fit_impact_coefficient(2, edges, none), InputError);
  const std::vector<double> grazing{-1, -0.9, 0.9, 1}, all_grazing{100, 0, 100};
  EXPECT_THROW(fit_impact_coefficient(2, grazing, all_grazing), InputError);
}

}  // namespace
}  // namespace sandglass::impact_fit_test

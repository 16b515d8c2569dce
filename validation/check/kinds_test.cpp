#include "validation/check/check.hpp"
#include "validation/check/synthetic.hpp"
#include "validation/law/mixture.hpp"
#include "validation/law/rough.hpp"

#include <cmath>

#include <gtest/gtest.h>

// Checks of mixtures and of particles that spin, on data drawn from the law and from one that is wrong on purpose.

namespace sandglass::synthetic::kinds_test {
namespace {

constexpr const char* kMixture = R"([run]
duration = { time = 100.0 }
[domain]
dimension = 2
size = [100.0, 100.0]
[[species]]
name = "a"
count = 1000
restitution = RESTITUTION
[[species]]
name = "b"
count = 500
diameter = 2.0
mass = 4.0
restitution = RESTITUTION
[method]
preset = "dsmc"
cells = [4, 4]
time-step = 0.1
[[observe]]
what = "species"
every = { time = 1.0 }
)";

constexpr const char* kRough = R"([run]
duration = { time = 100.0 }
[domain]
dimension = 3
size = [40.0, 40.0, 40.0]
[[species]]
count = 1000
restitution = 0.6
tangential-restitution = 0.0
[method]
preset = "dsmc"
cells = [4, 4, 4]
time-step = 0.1
[initial]
spin-temperature = 1.0
[[observe]]
what = "rotational-energy"
every = { time = 1.0 }
)";

Record of(std::string scene, const std::string& restitution, std::size_t replicas) {
  for (auto at = scene.find("RESTITUTION"); at != std::string::npos; at = scene.find("RESTITUTION"))
    scene.replace(at, 11, restitution);
  Record record = record_of({}, replicas);
  record.scene = scene;
  return record;
}

/// Counts that rise by their mean, with a scatter of one percent; `wide` is a factor on the rate of the mixed pair.
Record counted(double wide) {
  Record record = of(kMixture, "1.0", 1);
  const law::Component a{0.1, 1, 1, 1}, b{0.05, 2, 4, 1};
  const std::array rates{500 * law::mixture_collision_rate(2, a, a),
                         wide * 1000 * law::mixture_collision_rate(2, a, b),
                         250 * law::mixture_collision_rate(2, b, b)};
  Generator generator(3);
  std::normal_distribution<double> scatter(1, 0.01);
  Series& series = add_series(record, 0, "species-collisions", {"a:a", "a:b", "b:b"});
  std::vector<double> counts(3, 0);
  for (int i = 0; i <= 200; ++i) {
    add_sample(series, i, counts);
    for (std::size_t pair = 0; pair < 3; ++pair) counts[pair] += rates[pair] * scatter(generator);
  }
  return record;
}

double deviation(const Evidence& evidence) { return std::abs(evidence.value - evidence.expected); }

TEST(MixtureChecks, SeeAWrongCrossSectionOfOnePair) {
  const CheckInfo& check = find_check("species-collision-rates");
  const Evidence good = run_check(check, counted(1), {}), bad = run_check(check, counted(1.05), {});
  EXPECT_LT(deviation(good),
            5 * good.standard_error + 0.003);  // (N - 1)/N partners are part of the expectation
  EXPECT_NEAR(deviation(bad), 0.05, 0.005);
  EXPECT_EQ(bad.comparisons, 3);
}

Record cooled(double factor) {
  Record record = of(kMixture, "0.8", 1);
  const double ratio = law::mixture_temperature_ratio(2, 0.8, {0.1, 1, 1, 1}, {0.05, 2, 4, 1});
  Generator generator(4);
  std::normal_distribution<double> scatter(1, 0.02);
  Series& temperature = add_series(record, 0, "species-temperature", {"a", "b"});
  for (int i = 0; i <= 200; ++i)
    add_sample(temperature, i,
               {factor * ratio * std::exp(-0.01 * i) * scatter(generator), std::exp(-0.01 * i)});
  Series& collisions = add_series(record, 0, "collisions", {});
  for (int i = 0; i <= 200; ++i) add_sample(collisions, i, {750.0 * i});
  return record;
}

TEST(MixtureChecks, SeeEquipartitionWhereItBreaks) {
  const CheckInfo& check = find_check("species-temperature-ratio");
  const Settings settle{{{"settle-collisions", 10}}, 0, 0, ""};
  const Evidence good = run_check(check, cooled(1), settle),
                 bad = run_check(check, cooled(1 / good.expected), settle);
  EXPECT_LT(good.expected, 0.9);
  EXPECT_LT(deviation(good), 5 * good.standard_error);
  EXPECT_GT(deviation(bad), 20 * bad.standard_error);
}

/// Temperatures along mean field with another tangential restitution.
Record rough(double tangential) {
  Record record = of(kRough, "", 8);
  Generator generator(5);
  std::normal_distribution<double> scatter(1, 0.01);
  for (std::size_t replica = 0; replica < 8; ++replica) {
    const law::RoughGas gas{3, 0.6, tangential, 0.4};
    const auto fill = [&](const std::string& name, const std::vector<std::string>& components, auto value) {
      Series& series = add_series(record, replica, name, components);
      for (int i = 0; i <= 40; ++i) {
        const double tau = 0.25 * i;
        add_sample(series, i, std::vector<double>(std::max<std::size_t>(components.size(), 1), value(tau)));
      }
    };
    fill("temperature", {"x", "y", "z", "total"}, [&](double tau) {
      return law::rough_cooling(gas, {1, 1}, tau).translation * (tau > 0 ? scatter(generator) : 1);
    });
    fill("rotational-temperature", {}, [&](double tau) {
      return law::rough_cooling(gas, {1, 1}, tau).rotation * (tau > 0 ? scatter(generator) : 1);
    });
    fill("collisions", {}, [](double tau) { return 500 * tau; });
  }
  return record;
}

TEST(RoughChecks, SeeAWrongTangentialRestitution) {
  const Settings after{{{"collisions", 4}}, 0, 0, ""};
  for (const char* name : {"rough-translation", "rough-rotation"}) {
    const CheckInfo& check = find_check(name);
    const Evidence good = run_check(check, rough(0), after), bad = run_check(check, rough(0.5), after);
    EXPECT_LT(deviation(good), 5 * good.standard_error + good.budget.systematic) << name;
    EXPECT_GT(deviation(bad), 5 * bad.standard_error + bad.budget.systematic) << name;
  }
}

}  // namespace
}  // namespace sandglass::synthetic::kinds_test

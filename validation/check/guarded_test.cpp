#include "validation/law/guarded.hpp"

#include "validation/check/synthetic.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/haff.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace sandglass::guarded_test {
namespace {

using namespace synthetic;

/// Energy that follows dT/dt = -zeta(T) share(omega(T) t_c) in small steps, with the share's argument times `stretch`:
/// a guard of another contact time than the scene says.
Evidence guarded_of(double contact_time, double stretch) {
  const GasScene scene{
      .area_fraction = 0.4, .restitution = 0.87, .event_driven = true, .contact_time = contact_time};
  Record record = record_of(scene, 2);
  for (std::size_t replica = 0; replica < 2; ++replica) {
    add_series(record, replica, "energy", {});
    add_series(record, replica, "collisions", {});
    law::Gas gas = scene.gas();
    double time = 0, tau = 0;
    for (int i = 0; i <= 400; ++i) {
      if (i % 10 == 0) {
        add_sample(record.replicas[replica].series[0], time, {1000 * gas.temperature});
        add_sample(record.replicas[replica].series[1], time, {500 * tau});
      }
      const double rate = law::collision_rate(gas), step = 0.05 / rate;
      gas.temperature *=
          std::exp(-step * law::cooling_rate(gas) * law::guarded_share(2, stretch * rate * contact_time));
      time += step;
      tau += 0.05;
    }
  }
  return run_check(find_check("guarded-cooling"), record, {});
}

TEST(GuardedCooling, SeesItsOwnContactTimeAndNoOther) {
  const double contact_time = 0.1 / law::collision_rate(GasScene{.area_fraction = 0.4}.gas());
  const Evidence right = guarded_of(contact_time, 1);
  EXPECT_LT(std::abs(right.value - 1), right.budget.systematic);
  EXPECT_LT(right.budget.systematic, 0.06);
  const Evidence unguarded = guarded_of(contact_time, 0), twice = guarded_of(contact_time, 2);
  EXPECT_GT(unguarded.value - 1, 2 * unguarded.budget.systematic);
  EXPECT_GT(1 - twice.value, 2 * twice.budget.systematic);
}

TEST(GuardedCooling, LeavesHaffToUnguardedRuns) {
  const GasScene guarded{.restitution = 0.87, .event_driven = true, .contact_time = 0.01};
  const GasScene plain{.restitution = 0.87, .event_driven = true};
  EXPECT_FALSE(find_check("haff-cooling").applies(Subject(record_of(guarded, 1)).scene()));
  EXPECT_TRUE(find_check("haff-cooling").applies(Subject(record_of(plain, 1)).scene()));
  EXPECT_TRUE(find_check("guarded-cooling").applies(Subject(record_of(guarded, 1)).scene()));
  EXPECT_FALSE(find_check("guarded-cooling").applies(Subject(record_of(plain, 1)).scene()));
}

}  // namespace
}  // namespace sandglass::guarded_test

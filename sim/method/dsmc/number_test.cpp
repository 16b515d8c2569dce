#include "sim/base/error.hpp"
#include "sim/base/random.hpp"
#include "sim/method/dsmc/dsmc.hpp"

#include <algorithm>

#include <gtest/gtest.h>

// A number of particles that changes during a run.

namespace sandglass::dsmc::number_test {
namespace {

Particles<2> some_particles(std::size_t count, std::uint64_t stream) {
  Random random(StreamKey(5, Purpose::positions, 0, stream), 0);
  Particles<2> particles;
  for (std::size_t i = 0; i < count; ++i) {
    particles.phases.push_back(
        {{8 * random.uniform(), 8 * random.uniform()}, {2 * random.uniform() - 1, 2 * random.uniform() - 1}});
    particles.columns.append(column::weight, random.uniform());
  }
  return particles;
}

Dsmc<2> gas() {
  Parameters parameters;
  parameters.diameter = 0.2;
  parameters.cross_section = 0.4;
  parameters.factor.formula = henderson;
  return Dsmc<2>(Grid<2>(Vector<2>(8, 8), {8, 8}), parameters, {}, {}, Purpose::collisions,
                 {column::id, column::weight});
}

void advance(Dsmc<2>& dsmc, std::uint64_t first, std::uint64_t last) {
  for (std::uint64_t step = first; step < last; ++step) dsmc.step(0.1, step);
}

/// Every fourth particle leaves, and 300 come.
void change(Dsmc<2>& dsmc, std::uint64_t stream) {
  std::vector<std::uint32_t> leaving;
  for (std::uint32_t i = 0; i < dsmc.size(); i += 4) leaving.push_back(i);
  dsmc.remove(leaving);
  dsmc.insert(some_particles(300, stream));
}

Particles<2> shown(Dsmc<2>& dsmc) {
  const View<2> view = dsmc.view();
  Particles<2> particles{{view.particles.begin(), view.particles.end()}, {}};
  for (const ColumnView& column : view.columns) particles.columns.set(column);
  return particles;
}

void expect_same(const Particles<2>& one, const Particles<2>& other) {
  ASSERT_EQ(one.phases.size(), other.phases.size());
  for (std::size_t i = 0; i < one.phases.size(); ++i) {
    ASSERT_EQ(one.phases[i].position, other.phases[i].position);
    ASSERT_EQ(one.phases[i].velocity, other.phases[i].velocity);
  }
  EXPECT_TRUE(std::ranges::equal(one.columns.get(column::id), other.columns.get(column::id)));
  EXPECT_TRUE(std::ranges::equal(one.columns.get(column::weight), other.columns.get(column::weight)));
}

TEST(DsmcNumber, ParticlesComeAndGoBetweenSteps) {
  Dsmc<2> dsmc = gas();
  dsmc.assign(some_particles(1000, 0));
  advance(dsmc, 0, 3);
  EXPECT_EQ(dsmc.tally().moves, 3000u);
  change(dsmc, 1);
  EXPECT_EQ(dsmc.size(), 1050u);
  EXPECT_EQ(dsmc.view().particles.size(), 1050u);
  EXPECT_EQ(dsmc.view().offsets.back(), 1050u);
  EXPECT_EQ(*std::ranges::max_element(dsmc.ids()), 1299u);
  const std::uint64_t collisions = dsmc.tally().collisions;
  advance(dsmc, 3, 6);
  EXPECT_EQ(dsmc.tally().moves, 3000u + 3 * 1050);
  EXPECT_GT(dsmc.tally().collisions, collisions);
}

TEST(DsmcNumber, WhoStaysIsNotTouched) {
  Dsmc<2> dsmc = gas();
  dsmc.assign(some_particles(500, 0));
  const Particles<2> before = shown(dsmc);
  dsmc.insert(some_particles(40, 1));
  std::vector<std::uint32_t> newcomers;
  for (std::uint32_t i = 0; i < dsmc.size(); ++i)
    if (dsmc.ids()[i] >= 500) newcomers.push_back(i);
  EXPECT_EQ(newcomers.size(), 40u);
  dsmc.remove(newcomers);
  expect_same(shown(dsmc), before);
}

/// The contact factor keeps its window and the ids go on, although the particle of the greatest id has left.
TEST(DsmcNumber, GoesOnBitwiseAfterARestart) {
  Dsmc<2> dsmc = gas(), resumed = gas();
  dsmc.assign(some_particles(1000, 0));
  advance(dsmc, 0, 3);
  change(dsmc, 1);
  std::vector<std::uint32_t> greatest;
  for (std::uint32_t i = 0; i < dsmc.size(); ++i)
    if (dsmc.ids()[i] >= 1200) greatest.push_back(i);
  dsmc.remove(greatest);
  advance(dsmc, 3, 6);
  resumed.assign(shown(dsmc));
  resumed.load(dsmc.save());
  for (Dsmc<2>* one : {&dsmc, &resumed}) {
    change(*one, 2);
    advance(*one, 6, 9);
  }
  expect_same(shown(resumed), shown(dsmc));
  EXPECT_EQ(*std::ranges::max_element(resumed.ids()), 1599u);
}

/// The window of the contact factor is chosen for those who are still to come as well.
TEST(DsmcNumber, CountsThoseWhoAreStillToBePoured) {
  Parameters parameters;
  parameters.poured = 500;
  Dsmc<2> dsmc(Grid<2>(Vector<2>(8, 8), {8, 8}), parameters, {}, {});
  dsmc.assign(some_particles(20, 0));
  EXPECT_EQ(dsmc.save().at("dsmc/window").at(0), 520);
}

/// A method that has not said otherwise.
class Fixed final : public Simulator<2> {
 public:
  void assign(const Particles<2>&) override {}
  void step(double, std::uint64_t) override {}
  View<2> view() override { return {}; }
  std::span<const std::uint64_t> ids() const override { return {}; }
  std::uint64_t size() const override { return 0; }
  Tally& tally() override { return tally_; }
  std::size_t bytes() const override { return 0; }

 private:
  Tally tally_;
};

TEST(SimulatorNumber, IsFixedUnlessTheMethodSaysOtherwise) {
  Fixed fixed;
  EXPECT_THROW(fixed.insert(some_particles(1, 0)), RunError);
  const std::uint32_t first = 0;
  EXPECT_THROW(fixed.remove({&first, 1}), RunError);
}

}  // namespace
}  // namespace sandglass::dsmc::number_test

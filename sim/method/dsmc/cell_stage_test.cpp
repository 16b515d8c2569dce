#include "sim/method/dsmc/dsmc.hpp"

#include <algorithm>

#include <gtest/gtest.h>

// A stage that swaps velocities between neighbouring cells: what it keeps, and that the order of the pairs is no matter.

namespace sandglass::dsmc::cell_stage_test {
namespace {

constexpr std::uint32_t kCells = 5;  // odd: the checkerboard closes on itself with a third colour

/// The first particles of two neighbouring cells swap velocities; pairs of a colour in the order of `backwards`.
template <int D>
class Swap final : public CellStage<D> {
 public:
  explicit Swap(bool backwards) : backwards_(backwards) {}
  void apply(const CellStep<D>& step) override {
    for (int axis = 0; axis < D; ++axis)
      for (int colour = 0; colour < step.neighbours.colours(axis); ++colour) {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        step.neighbours.for_each_pair(
            axis, colour, [&](std::uint32_t low, std::uint32_t high) { pairs.emplace_back(low, high); });
        if (backwards_) std::ranges::reverse(pairs);
        for (const auto& [low, high] : pairs) swap(step.store, low, high);
      }
  }

 private:
  static void swap(ParticleStore<D>& store, std::uint32_t low, std::uint32_t high) {
    const auto offsets = store.offsets();
    if (offsets[low] == offsets[low + 1] || offsets[high] == offsets[high + 1]) return;
    std::swap(store.phases()[offsets[low]].velocity, store.phases()[offsets[high]].velocity);
  }
  bool backwards_;
};

template <int D>
std::vector<Phase<D>> particles() {
  Random random(StreamKey(1, Purpose::positions, 0, 0), 0);
  std::vector<Phase<D>> list(800);
  for (Phase<D>& particle : list)
    for (int axis = 0; axis < D; ++axis) {
      particle.position[axis] = kCells * random.uniform();
      particle.velocity[axis] = 2 * random.uniform() - 1;
    }
  return list;
}

template <int D>
Dsmc<D> simulation(std::unique_ptr<CellStage<D>> stage, double cross_section = 0) {
  std::array<std::uint32_t, D> cells;
  cells.fill(kCells);
  Parameters parameters;
  parameters.cross_section = cross_section;
  motion::MotionParameters<D> motion;
  motion.walled[0] = true;
  Dsmc<D> dsmc(Grid<D>(Vector<D>::Constant(kCells), cells), parameters, motion, {});
  if (stage) dsmc.add(std::move(stage));
  dsmc.assign({particles<D>(), {}});
  return dsmc;
}

template <int D>
std::vector<Phase<D>> after_steps(Dsmc<D> dsmc) {
  for (std::uint64_t step = 0; step < 10; ++step) dsmc.step(0.1, step);
  const auto view = dsmc.view().particles;
  return {view.begin(), view.end()};
}

template <int D>
bool same(const Phase<D>& a, const Phase<D>& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

template <int D>
void expect_order_to_be_no_matter() {
  const auto forwards = after_steps(simulation<D>(std::make_unique<Swap<D>>(false), 0.1));
  const auto backwards = after_steps(simulation<D>(std::make_unique<Swap<D>>(true), 0.1));
  const auto without = after_steps(simulation<D>(nullptr, 0.1));
  EXPECT_TRUE(std::ranges::equal(forwards, backwards, same<D>));
  EXPECT_FALSE(std::ranges::equal(forwards, without, same<D>));
}

TEST(CellStage, OrderOfPairsOfAColourIsNoMatter) {
  expect_order_to_be_no_matter<2>();
  expect_order_to_be_no_matter<3>();
}

/// Without collisions a swap keeps every velocity that there is, up to the side it points to after a wall.
TEST(CellStage, SwapKeepsEverySpeed) {
  auto before = particles<3>(), after = after_steps(simulation<3>(std::make_unique<Swap<3>>(false)));
  const auto by_speed = [](const Phase<3>& a, const Phase<3>& b) {
    return a.velocity.squaredNorm() < b.velocity.squaredNorm();
  };
  std::ranges::sort(before, by_speed);
  std::ranges::sort(after, by_speed);
  EXPECT_TRUE(std::ranges::equal(before, after, [](const Phase<3>& a, const Phase<3>& b) {
    return a.velocity.squaredNorm() == b.velocity.squaredNorm();
  }));
}

/// Reads the fields and compares them with sums over all particles.
template <int D>
class Look final : public CellStage<D> {
 public:
  CellNeeds needs(const CellStep<D>&) override { return {true, true, false}; }
  void apply(const CellStep<D>& step) override {
    const Grid<D>& grid = step.store.grid();
    for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
      double count = 0;
      Vector<D> momentum = Vector<D>::Zero();
      for (const Phase<D>& particle : step.store.phases())
        if (grid.cell_of(particle.position) == cell) ++count, momentum += particle.velocity;
      EXPECT_NEAR(step.fields.density[cell] * grid.cell_volume(), count, 1e-12);
      EXPECT_LT((step.fields.velocity[cell] * count - momentum).norm(), 1e-12);
    }
    EXPECT_TRUE(step.fields.energy.empty());
  }
};

TEST(CellStage, FieldsAreThoseOfTheCells) {
  Dsmc<2> dsmc = simulation<2>(std::make_unique<Look<2>>());
  const std::size_t bytes = dsmc.bytes();
  dsmc.step(0.1, 0);
  EXPECT_GT(dsmc.bytes(), bytes);
}

TEST(CellStage, DensityIsThatOfTheVolumeWithinWalls) {
  const Grid<2> corners(Vector<2>(2, 2), {1, 1});
  ParticleStore<2> store(LatticeOfCells<2>::diagonal(corners, {false, false}));
  store.assign({{{Vector<2>(0.1, 0.1), Vector<2>::Zero()}, {Vector<2>(1, 1), Vector<2>::Zero()}}, {}});
  CellFields<2> fields;
  fields.update({.density = true}, store);
  EXPECT_EQ(fields.density, (std::vector<double>{2, 0, 0.5, 0, 0}));
}

TEST(CellStage, CostsNoMemoryWhereThereIsNone) {
  Dsmc<2> dsmc = simulation<2>(nullptr);
  const std::size_t bytes = dsmc.bytes();
  dsmc.step(0.1, 0);
  EXPECT_EQ(dsmc.bytes(), bytes);
}

/// Elsewhere they are without meaning.
TEST(CellStage, FieldsAreFilledWhereTheyAreRead) {
  ParticleStore<2> store(Grid<2>(Vector<2>(3, 1), {3, 1}));
  store.assign({{{{0.5, 0.5}, {1, 2}}, {{1.5, 0.5}, {3, 4}}, {{2.5, 0.5}, {5, 6}}}, {}});
  CellFields<2> fields;
  const std::vector<std::uint8_t> where{0, 1, 1};
  fields.update({.velocity = true, .where = where}, store);
  ASSERT_EQ(fields.velocity.size(), 3U);
  EXPECT_EQ(fields.velocity[1], Vector<2>(3, 4));
  EXPECT_EQ(fields.velocity[2], Vector<2>(5, 6));
}

/// Whether the sort has added up or not: the same to the last digit.
TEST(CellStage, MeanVelocitiesMayComeFromTheSort) {
  const std::array<std::uint32_t, 3> cells{kCells, kCells, kCells};
  const Grid<3> grid(Vector<3>::Constant(kCells), cells);
  ParticleStore<3> plain(grid), summed(grid);
  summed.sum_velocities(true);
  plain.assign({particles<3>(), {}});
  summed.assign({particles<3>(), {}});
  ASSERT_FALSE(summed.velocity_sums().empty());
  CellFields<3> fields, quick;
  fields.update({.velocity = true}, plain);
  quick.update({.velocity = true}, summed);
  EXPECT_EQ(quick.velocity, fields.velocity);
}

/// A stage sees the velocities that those before it have left.
TEST(CellStage, SeesWhatTheOneBeforeHasChanged) {
  Dsmc<2> dsmc = simulation<2>(std::make_unique<Swap<2>>(false));
  dsmc.add(std::make_unique<Look<2>>());
  for (std::uint64_t step = 0; step < 3; ++step) dsmc.step(0.1, step);
}

TEST(CellStage, EnergyIsThatOfTheParticles) {
  ParticleStore<3> store(Grid<3>(Vector<3>(1, 1, 1), {1, 1, 1}));
  store.assign({{{{0, 0, 0}, {1, 2, 2}}, {{0, 0, 0}, {0, 0, 4}}}, {}});
  CellFields<3> fields;
  fields.update({false, false, true}, store);
  EXPECT_EQ(fields.energy, std::vector<double>{12.5});
}

}  // namespace
}  // namespace sandglass::dsmc::cell_stage_test

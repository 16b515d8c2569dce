#include "sim/space/particle_store.hpp"

#include "sim/base/random.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace sandglass::particle_store_test {
namespace {

constexpr std::size_t kParticles = 500;

template <int D>
Grid<D> grid() {
  std::array<std::uint32_t, D> cells;
  cells.fill(4);
  return {Vector<D>::Constant(1), cells};
}

template <int D>
Vector<D> random_point(Random& random) {
  Vector<D> point;
  for (int axis = 0; axis < D; ++axis) point[axis] = random.uniform();
  return point;
}

/// The velocity names the particle: id, and id squared.
template <int D>
Vector<D> mark(std::uint64_t id) {
  Vector<D> velocity = Vector<D>::Zero();
  velocity[0] = static_cast<double>(id);
  velocity[D - 1] = static_cast<double>(id * id);
  return velocity;
}

template <int D>
Particles<D> marked_particles(std::size_t count = kParticles) {
  Random random(StreamKey(4, Purpose::positions, 0, 0), 0);
  std::vector<Phase<D>> particles(count);
  for (std::size_t i = 0; i < count; ++i) particles[i] = {random_point<D>(random), mark<D>(i)};
  return {particles, {}};
}

/// As a method does it: new positions, counted into their cells one after the other.
template <int D>
void move_everything(ParticleStore<D>& store, std::uint64_t step) {
  Random random(StreamKey(4, Purpose::positions, 0, step), 1);
  store.begin_step();
  for (std::size_t i = 0; i < store.size(); ++i) {
    store.phases()[i].position = random_point<D>(random);
    const std::uint32_t cell = store.grid().cell_of(store.phases()[i].position);
    store.places()[i] = {cell, store.arrivals()[cell]++};
  }
}

template <int D>
bool same(const Phase<D>& a, const Phase<D>& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

/// The slow twin: a stable sort by cell keeps the order of (old cell, old place).
template <int D>
std::vector<Phase<D>> stably_sorted(std::span<const Phase<D>> particles, const Grid<D>& cells) {
  std::vector<Phase<D>> list(particles.begin(), particles.end());
  std::ranges::stable_sort(list, {},
                           [&](const Phase<D>& particle) { return cells.cell_of(particle.position); });
  return list;
}

template <int D>
void expect_offsets_of_cells(const ParticleStore<D>& store) {
  const auto offsets = store.offsets();
  ASSERT_EQ(offsets.size(), store.grid().size() + 1u);
  EXPECT_EQ(offsets.front(), 0u);
  EXPECT_EQ(offsets.back(), store.size());
  for (std::uint32_t cell = 0; cell < store.grid().size(); ++cell)
    for (std::uint32_t i = offsets[cell]; i < offsets[cell + 1]; ++i)
      ASSERT_EQ(store.grid().cell_of(store.phases()[i].position), cell);
}

template <int D>
void expect_stable_sort(const std::vector<ColumnInfo>& columns) {
  ParticleStore<D> store(grid<D>(), columns);
  store.assign(marked_particles<D>());
  for (std::uint64_t step = 0; step < 5; ++step) {
    move_everything(store, step);
    const auto expected = stably_sorted<D>(store.phases(), store.grid());
    store.sort();
    ASSERT_TRUE(std::ranges::equal(store.phases(), expected, same<D>)) << "step " << step;
    expect_offsets_of_cells(store);
  }
}

TEST(ParticleStore, SortsLikeAStableSort) {
  expect_stable_sort<2>({});
  expect_stable_sort<3>({column::id, column::spin<3>});
}

template <int D>
void expect_ids_travel() {
  ParticleStore<D> store(grid<D>(), {column::id});
  store.assign(marked_particles<D>());
  for (std::uint64_t step = 0; step < 5; ++step) {
    move_everything(store, step);
    store.sort();
    for (std::size_t i = 0; i < store.size(); ++i)
      ASSERT_EQ(store.phases()[i].velocity, mark<D>(store.ids()[i]));
  }
}

TEST(ParticleStore, IdsTravelWithTheirParticles) {
  expect_ids_travel<2>();
  expect_ids_travel<3>();
}

TEST(ParticleStore, TakesIds) {
  auto particles = marked_particles<2>();
  for (std::uint64_t i = 0; i < kParticles; ++i) particles.columns.append(column::id, 1000 + 7 * i);
  ParticleStore<2> store(grid<2>(), {column::id});
  store.assign(particles);
  for (std::size_t i = 0; i < store.size(); ++i)
    ASSERT_EQ(store.phases()[i].velocity, mark<2>((store.ids()[i] - 1000) / 7));
}

TEST(ParticleStore, KeepsNoIdsUnasked) {
  ParticleStore<2> store(grid<2>());
  store.assign(marked_particles<2>());
  EXPECT_TRUE(store.ids().empty());
}

/// Those of a loop over the particles of each cell, to the last digit.
template <int D>
void expect_sums_of_cells(const ParticleStore<D>& store) {
  const auto sums = store.velocity_sums(), particles = store.phases();
  ASSERT_GE(sums.size(), store.cells().size());
  for (std::uint32_t cell = 0; cell < store.cells().size(); ++cell) {
    Vector<D> sum = Vector<D>::Zero();
    for (std::uint32_t i = store.offsets()[cell]; i < store.offsets()[cell + 1]; ++i)
      sum += particles[i].velocity;
    EXPECT_EQ(sums[cell], sum) << "cell " << cell;
  }
}

/// Velocities whose sum depends on their order.
template <int D>
Particles<D> particles_in_motion() {
  Random random(StreamKey(4, Purpose::velocities, 0, 0), 0);
  Particles<D> particles = marked_particles<D>();
  for (Phase<D>& particle : particles.phases) particle.velocity = random_point<D>(random) - mark<D>(1) / 3;
  return particles;
}

template <int D>
void expect_sums_in_the_order_of_the_cells() {
  ParticleStore<D> store(grid<D>());
  store.assign(particles_in_motion<D>());
  EXPECT_TRUE(store.velocity_sums().empty());
  store.sum_velocities(true);
  for (std::uint64_t step = 0; step < 3; ++step) {
    move_everything(store, step);
    store.insert(particles_in_motion<D>());
    store.sort();
    expect_sums_of_cells(store);
    store.stay(std::vector<std::uint32_t>{1, 7, 8, 100});
    store.sort();
    expect_sums_of_cells(store);
  }
  store.velocities_changed();
  EXPECT_TRUE(store.velocity_sums().empty());
}

TEST(ParticleStore, AddsUpVelocitiesAsTheyArrive) {
  expect_sums_in_the_order_of_the_cells<2>();
  expect_sums_in_the_order_of_the_cells<3>();
}

TEST(ParticleStore, MayBeFilledAgainWithOtherNumbers) {
  ParticleStore<2> store(grid<2>(), {column::id});
  for (std::size_t count : {kParticles, std::size_t{3}, std::size_t{0}, 2 * kParticles}) {
    store.assign(marked_particles<2>(count));
    ASSERT_EQ(store.size(), count);
    expect_offsets_of_cells(store);
    EXPECT_EQ(store.ids().size(), count);
  }
}

/// Two buffers of phases and of each column that is kept, and a place; two counters a cell, and for what is removed.
TEST(ParticleStore, KnowsItsBytes) {
  const auto bytes = [](const std::vector<ColumnInfo>& columns) {
    ParticleStore<3> store(grid<3>(), columns);
    store.assign(marked_particles<3>());
    return store.bytes();
  };
  constexpr std::size_t kPhases = kParticles * (2 * 48 + 8) + 2 * 66 * 4;
  EXPECT_EQ(bytes({}), kPhases);
  EXPECT_EQ(bytes({column::id}), kPhases + kParticles * 16);
  EXPECT_EQ(bytes({column::species, column::spin<3>}), kPhases + kParticles * (2 + 48));
}

}  // namespace
}  // namespace sandglass::particle_store_test

#include "sim/base/error.hpp"
#include "sim/base/random.hpp"
#include "sim/space/particle_store.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

// Particles that come and go, with every column, against a list that is kept by hand.

namespace sandglass::particle_store_number_test {
namespace {

constexpr ColumnKey<Vector<2>> kMadeUp{"made-up", "length", 7};

/// One particle with its columns; `name` is what the test calls it.
struct Row {
  Phase<2> phase;
  std::uint64_t id;
  std::uint8_t species;
  double weight;
  Spin<2> spin;
  Vector<2> made_up;

  bool operator==(const Row& other) const {
    return phase.position == other.phase.position && phase.velocity == other.phase.velocity &&
           id == other.id && species == other.species && weight == other.weight && spin == other.spin &&
           made_up == other.made_up;
  }
};

Grid<2> grid() { return {Vector<2>(1, 1), {5, 4}}; }

ParticleStore<2> empty_store() {
  return ParticleStore<2>(grid(), {column::id, column::species, column::weight, column::spin<2>, kMadeUp});
}

std::vector<Row> rows(std::uint64_t first_id, std::size_t count) {
  Random random(StreamKey(9, Purpose::positions, 0, first_id), 0);
  std::vector<Row> list(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t id = first_id + i;
    const auto mark = static_cast<double>(id);
    list[i] = {{{random.uniform(), random.uniform()}, {mark, -mark}},
               id,
               static_cast<std::uint8_t>(id % 200),
               1 / (1 + mark),
               Spin<2>(mark / 3),
               {mark, mark * mark}};
  }
  return list;
}

Particles<2> particles_of(const std::vector<Row>& list, bool ids) {
  Particles<2> particles;
  for (const Row& row : list) {
    particles.phases.push_back(row.phase);
    if (ids) particles.columns.append(column::id, row.id);
    particles.columns.append(column::species, row.species);
    particles.columns.append(column::weight, row.weight);
    particles.columns.append(column::spin<2>, row.spin);
    particles.columns.append(kMadeUp, row.made_up);
  }
  return particles;
}

std::vector<Row> rows_of(ParticleStore<2>& store) {
  std::vector<Row> list;
  for (std::size_t i = 0; i < store.size(); ++i)
    list.push_back({store.phases()[i], store.ids()[i], store.column(column::species)[i],
                    store.column(column::weight)[i], store.column(column::spin<2>)[i],
                    store.column(kMadeUp)[i]});
  return list;
}

/// The slow twin of a sort: what is left in its order, then what came, stably by cell.
std::vector<Row> sorted(std::vector<Row> left, const std::vector<Row>& came) {
  left.insert(left.end(), came.begin(), came.end());
  std::ranges::stable_sort(left, {}, [](const Row& row) { return grid().cell_of(row.phase.position); });
  return left;
}

std::vector<Row> without(const std::vector<Row>& list, const std::vector<std::uint32_t>& places) {
  std::vector<Row> left;
  for (std::uint32_t i = 0; i < list.size(); ++i)
    if (std::ranges::find(places, i) == places.end()) left.push_back(list[i]);
  return left;
}

void expect_offsets(const ParticleStore<2>& store) {
  const auto offsets = store.offsets();
  ASSERT_EQ(offsets.size(), grid().size() + 1u);
  ASSERT_EQ(offsets.back(), store.size());
  for (std::uint32_t cell = 0; cell < grid().size(); ++cell)
    for (std::uint32_t i = offsets[cell]; i < offsets[cell + 1]; ++i)
      ASSERT_EQ(grid().cell_of(store.phases()[i].position), cell);
}

TEST(ParticleStoreNumber, ComesAndGoesLikeItsTwin) {
  ParticleStore<2> store = empty_store();
  store.assign(particles_of(rows(0, 300), false));
  std::vector<Row> expected = sorted(rows(0, 300), {});
  std::uint64_t next = 300;
  Random random(StreamKey(9, Purpose::species, 0, 0), 0);
  for (int round = 0; round < 30; ++round) {
    std::vector<std::uint32_t> leaving;
    for (std::uint32_t i = 0; i < store.size(); ++i)
      if (random.uniform() < 0.1) leaving.push_back(i);
    const std::vector<Row> came = rows(next, round % 3 == 0 ? 0 : 10 * static_cast<std::size_t>(round));
    next += came.size();
    store.stay(leaving);
    store.insert(particles_of(came, false));
    store.sort();
    expected = sorted(without(expected, leaving), came);
    ASSERT_EQ(rows_of(store), expected) << "round " << round;
    expect_offsets(store);
  }
  EXPECT_EQ(store.next_id(), next);
}

/// As an open boundary does it: some of those that move arrive nowhere.
TEST(ParticleStoreNumber, AMotionMayDropParticles) {
  ParticleStore<2> store = empty_store();
  store.assign(particles_of(rows(0, 200), true));
  std::vector<Row> moved = rows_of(store);
  store.begin_step();
  for (std::size_t i = 0; i < store.size(); ++i) {
    Vector<2>& position = store.phases()[i].position;
    position[0] += 0.3;
    moved[i].phase.position = position;
    const std::uint32_t cell = position[0] < 1 ? grid().cell_of(position) : store.removed();
    store.places()[i] = {cell, store.arrivals()[cell]++};
  }
  store.sort();
  std::erase_if(moved, [](const Row& row) { return row.phase.position[0] >= 1; });
  EXPECT_LT(moved.size(), 180u);
  EXPECT_EQ(rows_of(store), sorted(moved, {}));
  expect_offsets(store);
}

/// The cells are displaced between the motion, which drops some, and the sort.
TEST(ParticleStoreNumber, WhoIsRemovedIsNotFoundAgain) {
  auto cells = LatticeOfCells<2>::shifted(grid(), {false, true});
  ParticleStore<2> store(cells);
  store.assign(particles_of(rows(0, 200), false));
  store.stay(std::vector<std::uint32_t>{3, 77});
  cells.shift({0.4, -0.3});
  store.shift_cells({0.4, -0.3});
  store.find_cells();
  EXPECT_EQ(store.arrivals()[store.removed()], 2u);
  store.sort();
  EXPECT_EQ(store.size(), 198u);
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell)
    for (std::uint32_t i = store.offsets()[cell]; i < store.offsets()[cell + 1]; ++i)
      ASSERT_EQ(cells.cell_of(store.phases()[i].position), cell);
}

/// After a motion into new cells, as the sort would leave those who are not dropped.
TEST(ParticleStoreNumber, DropsSomeOfThoseWhoMoved) {
  const std::vector<std::uint32_t> leaving{3, 77, 12, 199};
  ParticleStore<2> some = empty_store(), all = empty_store();
  for (ParticleStore<2>* store : {&some, &all}) {
    store->assign(particles_of(rows(0, 200), true));
    for (Phase<2>& particle : store->phases()) particle.position[0] *= 0.5;
    store->find_cells();
  }
  std::set<std::uint64_t> gone;
  for (const std::uint32_t place : leaving) gone.insert(some.ids()[place]);
  some.drop(leaving);
  some.sort();
  all.sort();
  std::vector<Row> stayed = rows_of(all);
  std::erase_if(stayed, [&gone](const Row& row) { return gone.contains(row.id); });
  EXPECT_EQ(rows_of(some), stayed);
  expect_offsets(some);
}

TEST(ParticleStoreNumber, PicksCopiesWithAllTheirColumns) {
  ParticleStore<2> store = empty_store();
  store.assign(particles_of(rows(0, 50), true));
  const std::vector<std::uint32_t> places{7, 7, 30};
  const std::vector<Row> before = rows_of(store);
  ParticleStore<2> copies = empty_store();
  copies.assign(pick<2>(store.phases(), store.columns(), places));
  std::vector<Row> picked = rows_of(copies);
  ASSERT_EQ(picked.size(), 3u);
  for (const std::uint32_t place : places)
    EXPECT_NE(std::ranges::find(picked, before[place]), picked.end()) << place;
}

TEST(ParticleStoreNumber, TheOrderOfTheRequestsDoesNotShow) {
  const std::vector<std::uint32_t> leaving{3, 77, 12, 3, 199};
  const auto came = particles_of(rows(500, 40), false);
  ParticleStore<2> one = empty_store(), other = empty_store();
  for (ParticleStore<2>* store : {&one, &other}) store->assign(particles_of(rows(0, 200), true));
  one.stay(leaving);
  one.insert(came);
  one.sort();
  std::vector<std::uint32_t> backwards(leaving.rbegin(), leaving.rend());
  other.insert(came);
  other.stay(backwards);
  other.sort();
  EXPECT_EQ(one.size(), 200u - 4 + 40);
  EXPECT_EQ(rows_of(one), rows_of(other));
}

TEST(ParticleStoreNumber, IdsAreNeverGivenTwice) {
  ParticleStore<2> store = empty_store();
  store.assign(particles_of(rows(1000, 50), true));
  std::set<std::uint64_t> seen(store.ids().begin(), store.ids().end());
  EXPECT_EQ(store.next_id(), 1050u);
  for (int round = 0; round < 5; ++round) {
    std::vector<std::uint32_t> everything(store.size());
    for (std::uint32_t i = 0; i < everything.size(); ++i) everything[i] = i;
    store.stay(everything);
    store.insert(particles_of(rows(0, 20), true));  // their own ids do not count
    store.sort();
    for (const std::uint64_t id : store.ids()) EXPECT_TRUE(seen.insert(id).second) << id;
  }
  EXPECT_EQ(seen.size(), 150u);
}

TEST(ParticleStoreNumber, WhatIsNotGivenHasItsInitialValue) {
  ParticleStore<2> store = empty_store();
  for (int round = 0; round < 2; ++round) {
    store.stay();
    store.insert({{{{0.5, 0.5}, {1, 2}}}, {}});
    store.sort();
  }
  for (const Row& row : rows_of(store)) {
    EXPECT_EQ(row.weight, 1);
    EXPECT_EQ(row.species, 0);
    EXPECT_EQ(row.spin[0], 0);
    EXPECT_EQ(row.made_up, Vector<2>(7, 7));
  }
  EXPECT_EQ(store.ids()[1], 1u);
}

TEST(ParticleStoreNumber, AbsentColumnsCostNothingAndAreNotShown) {
  ParticleStore<2> store(grid());
  store.assign(particles_of(rows(0, 100), true));
  EXPECT_TRUE(store.column(column::weight).empty());
  EXPECT_EQ(store.columns().begin(), store.columns().end());
}

TEST(ParticleStoreNumber, RefusesColumnsOfAnotherLengthOrType) {
  ParticleStore<2> store = empty_store();
  Particles<2> particles = particles_of(rows(0, 3), false);
  particles.columns.append(column::weight, 1);
  EXPECT_THROW(store.assign(particles), InputError);
  EXPECT_THROW(store.insert(particles), InputError);
  particles = particles_of(rows(0, 3), false);
  particles.columns.remove("weight");
  constexpr ColumnKey<std::uint64_t> kOtherType{"weight", "1"};
  particles.columns.set(kOtherType, std::vector<std::uint64_t>(3));
  EXPECT_THROW(store.assign(particles), InputError);
}

}  // namespace
}  // namespace sandglass::particle_store_number_test

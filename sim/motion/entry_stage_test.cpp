#include "sim/motion/entry_stage.hpp"

#include "sim/motion/stream_index.hpp"
#include "sim/motion/test_flight.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

// Moves that may be refused, against a slow twin and against the motion that refuses none.

namespace sandglass::motion::entry_stage_test {
namespace {

template <int D>
struct Moved {
  std::vector<Phase<D>> particles;
  std::uint64_t refused = 0;
};

/// The slow twin: all fly, who should not have is put back, and each cell gets a list.
template <int D>
Moved<D> moved_by_hand(const ParticleStore<D>& store, const MotionStage<D>& motion, const MotionStep& step,
                       const CellEntries& entries) {
  ParticleStore<D> flown = store_of<D>({store.phases().begin(), store.phases().end()}, store.cells());
  advance(motion, flown, step);
  Moved<D> moved;
  std::vector<std::vector<Phase<D>>> lists(store.cells().size() + 1);
  for (std::uint32_t cell = 0; cell < store.cells().size(); ++cell)
    for (std::uint32_t i = store.offsets()[cell]; i < store.offsets()[cell + 1]; ++i) {
      const std::uint32_t to = flown.places()[i].cell;
      const double drawn = Random(entries.key, stream_index(cell, i - store.offsets()[cell])).uniform();
      const bool asks = to != store.removed() && (to != cell || entries.within_too);
      if (!asks || (entries.full[to] == 0 && (to == cell || drawn < entries.probability[to]))) {
        lists[to].push_back(flown.phases()[i]);
        continue;
      }
      ++moved.refused;
      lists[cell].push_back(store.phases()[i]);
      store.cells().put_into(cell, lists[cell].back().position);
    }
  lists.pop_back();  // who left the box
  for (const auto& list : lists) moved.particles.insert(moved.particles.end(), list.begin(), list.end());
  return moved;
}

template <int D>
bool same(const Phase<D>& a, const Phase<D>& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

template <int D>
MotionParameters<D> surroundings(int which) {
  MotionParameters<D> parameters;
  if (which > 0) parameters.walled[0] = true, parameters.gravity[0] = -1;
  if (which > 1) parameters.walls = {wall<D>(0, false, {WallKind::thermal, {}, 1, 2})};
  if (which > 1) parameters.obstacles = some_obstacles<D>({WallKind::thermal});
  if (which > 2) parameters.walls.clear(), parameters.open[0] = {true, true};
  return parameters;
}

template <int D>
void expect_like_twin(int which, const LatticeOfCells<D>& lattice, bool within_too) {
  const auto parameters = surroundings<D>(which);
  const std::uint32_t cells = lattice.size();
  auto store = scattered<D>(2, 0, 16 * cells, lattice);
  const auto stage = make_entry_stage<D>(parameters, box<D>());
  const auto motion = make_motion_stage<D>(parameters, box<D>());
  std::uint64_t all = 0;
  for (std::uint64_t step = 0; step < 10; ++step) {
    std::vector<std::uint8_t> full(cells + 1);
    std::vector<float> probability(cells + 1, 1);
    for (std::uint32_t cell = 0; cell < cells; ++cell) {
      full[cell] = (cell + step) % 3 == 0;
      probability[cell] = (cell + step) % 5 == 0 ? 0.3F : 1;
    }
    const CellEntries entries{full.data(), probability.data(), wall_key(100 + step), within_too};
    const MotionStep now{0.2, 0, wall_key(step)};
    const Moved<D> expected = moved_by_hand(store, *motion, now, entries);
    store.begin_step();
    std::uint64_t refused = 0;
    for (std::uint32_t first = 0; first < cells; first += 7)
      refused += stage->advance(store, first, std::min(first + 7, cells), now, entries);
    store.sort();
    ASSERT_EQ(refused, expected.refused);
    ASSERT_TRUE(std::ranges::equal(store.phases(), expected.particles, same<D>)) << "step " << step;
    all += refused;
  }
  EXPECT_GT(all, 300U);
}

TEST(EntryStage, MovesLikeItsTwin) {
  for (int which = 0; which < 4; ++which) {
    expect_like_twin<2>(which, five_cells<2>(), false);
    expect_like_twin<3>(which, five_cells<3>(), false);
  }
}

/// Who is refused at a rough wall keeps its spin, who is not turns once, whether passages are counted or not.
TEST(EntryStage, SpinsChangeWithTheFlightAlone) {
  for (const bool counts : {false, true}) {
    MotionParameters<2> parameters;
    parameters.walled[0] = true;
    parameters.species = {{0.1, 1, 0.00125}};
    const WallRule rough{WallKind::specular, {{1}, 1}};
    parameters.walls = {wall<2>(0, false, rough), wall<2>(0, true, rough)};
    std::vector<Plane> planes{{1, 0.4, {-10, 10}}};
    if (counts) parameters.planes = &planes;
    const auto plain = scattered<2>(5, 0);
    ParticleStore<2> store(plain.cells(), {column::spin<2>}), flown(plain.cells(), {column::spin<2>});
    Particles<2> all{{plain.phases().begin(), plain.phases().end()}, {}};
    all.columns.set(column::spin<2>, std::vector<Spin<2>>(all.phases.size(), Spin<2>(3)));
    store.assign(all);
    flown.assign(all);
    const MotionStep step{0.2, 0, wall_key(0)};
    advance(*make_motion_stage<2>(parameters, box<2>()), flown, step);
    const std::vector<std::uint8_t> full(store.cells().size() + 1, 1);
    store.begin_step();
    const Particles<2> before{{store.phases().begin(), store.phases().end()}, {}};
    make_entry_stage<2>(parameters, box<2>())->advance(store, 0, store.cells().size(), step, {full.data()});
    std::size_t turned = 0;
    for (std::size_t i = 0; i < store.size(); ++i) {
      const bool stays = store.grid().cell_of(before.phases[i].position) == flown.places()[i].cell;
      const Spin<2> expected = stays ? flown.column(column::spin<2>)[i] : Spin<2>(3);
      ASSERT_EQ(store.column(column::spin<2>)[i], expected);
      turned += expected != Spin<2>(3);
    }
    EXPECT_GT(turned, 20u);
  }
}

TEST(EntryStage, KnowsEveryLattice) {
  for (int which = 0; which < 4; ++which) {
    const bool around = which == 0;
    auto squares = LatticeOfCells<2>::shifted(five_cells<2>(), {around, true});
    auto cubes = LatticeOfCells<3>::shifted(five_cells<3>(), {around, true, true});
    squares.shift({0.3, -0.4});
    cubes.shift({-0.2, 0.1, 0.45});
    expect_like_twin<2>(which, squares, true);
    expect_like_twin<3>(which, cubes, true);
    expect_like_twin<2>(which, LatticeOfCells<2>::diagonal(five_cells<2>(), {around, true}), false);
  }
}

/// One step of all particles through planes and past walls that count; every cell takes in all or nobody.
template <int D>
ParticleStore<D> counted_step(MotionParameters<D> parameters, std::vector<Plane>& planes,
                              WallImpulses<D>& impulses, bool closed) {
  parameters.planes = &planes;
  parameters.impulses = &impulses;
  auto store = scattered<D>(3);
  const std::vector<std::uint8_t> full(store.cells().size() + 1, closed);
  store.begin_step();
  make_entry_stage<D>(parameters, box<D>())
      ->advance(store, 0, store.cells().size(), {0.5, 0, wall_key(1)}, {full.data(), nullptr, {}, closed});
  store.sort();
  return store;
}

template <int D>
void expect_counts(int which) {
  std::vector<Plane> planes{{1, 0.8, {-5, 0, 5}}}, free = planes, none = planes;
  WallImpulses<D> of_moved, of_free, of_refused;
  const auto moved = counted_step<D>(surroundings<D>(which), planes, of_moved, false);
  auto parameters = surroundings<D>(which);
  parameters.planes = &free;
  parameters.impulses = &of_free;
  auto store = scattered<D>(3);
  const std::vector<Phase<D>> before(store.phases().begin(), store.phases().end());
  advance(*make_motion_stage<D>(parameters, box<D>()), store, {0.5, 0, wall_key(1)});
  store.sort();
  EXPECT_TRUE(std::ranges::equal(moved.phases(), store.phases(), same<D>));
  EXPECT_GT(planes[0].up(), 100);
  EXPECT_EQ(planes[0].up(), free[0].up());
  EXPECT_EQ(planes[0].down(), free[0].down());
  EXPECT_GT(of_moved.impulse(1).norm(), 10);
  EXPECT_EQ(of_moved.impulse(1), of_free.impulse(1));
  const auto refused = counted_step<D>(surroundings<D>(which), none, of_refused, true);
  EXPECT_TRUE(std::ranges::equal(refused.phases(), before, same<D>));
  EXPECT_EQ(none[0].up() + none[0].down(), 0);
  EXPECT_EQ(of_refused.impulse(1), (Vector<D>::Zero()));
}

/// Who is refused keeps all that it has, and nothing counts it.
TEST(EntryStage, CountsMovesThatHappen) {
  for (const int which : {1, 2}) {
    expect_counts<2>(which);
    expect_counts<3>(which);
  }
}

}  // namespace
}  // namespace sandglass::motion::entry_stage_test

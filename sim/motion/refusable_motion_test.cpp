#include "sim/motion/refusable_motion.hpp"

#include "sim/motion/stream_index.hpp"
#include "sim/motion/test_flight.hpp"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

namespace sandglass::motion {
namespace {

constexpr std::uint32_t kMost = 18;  ///< particles in a cell; 16 on average

/// At most kMost particles in a cell: of those who would enter, the ones whose stream draws least may, as many as there is
/// room for.
template <int D>
class RoomForFew final : public EntryRule<D> {
 public:
  void decide(const Proposals<D>& moves) override {
    std::vector<std::vector<std::pair<std::uint64_t, std::size_t>>> queue(moves.cells.size());
    for (std::uint32_t cell = 0; cell < moves.cells.size(); ++cell)
      for (std::uint32_t i = moves.offsets[cell]; i < moves.offsets[cell + 1]; ++i)
        if (moves.targets[i] != cell)
          queue[moves.targets[i]].push_back({draw(cell, i - moves.offsets[cell]), i});
    for (std::uint32_t cell = 0; cell < moves.cells.size(); ++cell) {
      ASSERT_EQ(queue[cell].size(), moves.entering[cell]);
      const std::uint32_t held = moves.offsets[cell + 1] - moves.offsets[cell];
      std::ranges::sort(queue[cell]);
      for (std::size_t rank = held < kMost ? kMost - held : 0; rank < queue[cell].size(); ++rank)
        moves.refused[queue[cell][rank].second] = 1;
    }
    refused += std::ranges::count(moves.refused, 1);
  }
  static std::uint64_t draw(std::uint32_t cell, std::uint32_t place) {
    return Random(StreamKey(1, Purpose::crossings, 0, 0), stream_index(cell, place)).bits();
  }
  std::ptrdiff_t refused = 0;
};

template <int D>
class NoRule final : public EntryRule<D> {
 public:
  void decide(const Proposals<D>&) override {}
};

template <int D>
MotionParameters<D> thermal_room(bool plain) {
  MotionParameters<D> parameters;
  parameters.walled[0] = true;
  parameters.gravity[0] = -1;
  if (plain) return parameters;
  parameters.walls = {wall<D>(0, false, {WallKind::thermal, {}, 1, 2})};
  parameters.obstacles = some_obstacles<D>({WallKind::thermal});
  return parameters;
}

/// No more than kMost and about that many in every cell.
template <int D>
ParticleStore<D> crowd() {
  return scattered<D>(2, 0, 16 * (D == 2 ? 25 : 125));
}

template <int D>
bool same(const Phase<D>& a, const Phase<D>& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

/// The slow twin: every particle is flown by itself, held back where its cell says so, and put into a list per cell.
template <int D>
std::vector<Phase<D>> refused_by_hand(const ParticleStore<D>& store, const MotionParameters<D>& parameters,
                                      const MotionStep& step) {
  ParticleStore<D> flown = store_of<D>({store.phases().begin(), store.phases().end()});
  advance(*make_motion_stage<D>(parameters, box<D>()), flown, step);
  const std::uint32_t cells = store.grid().size();
  std::vector<std::uint32_t> from(store.size()), to(store.size());
  std::vector<std::map<std::uint64_t, std::size_t>> queue(cells);
  for (std::uint32_t cell = 0; cell < cells; ++cell)
    for (std::uint32_t i = store.offsets()[cell]; i < store.offsets()[cell + 1]; ++i) {
      from[i] = cell, to[i] = flown.grid().cell_of(flown.phases()[i].position);
      if (from[i] != to[i]) queue[to[i]][RoomForFew<D>::draw(cell, i - store.offsets()[cell])] = i;
    }
  std::vector<bool> moves(store.size(), true);
  for (std::uint32_t cell = 0; cell < cells; ++cell) {
    std::uint32_t held = store.offsets()[cell + 1] - store.offsets()[cell];
    for (const auto& [key, i] : queue[cell]) moves[i] = held++ < kMost;
  }
  std::vector<std::vector<Phase<D>>> lists(cells);
  for (std::size_t i = 0; i < store.size(); ++i)
    lists[moves[i] ? to[i] : from[i]].push_back(moves[i] ? flown.phases()[i] : store.phases()[i]);
  std::vector<Phase<D>> particles;
  for (const auto& list : lists) particles.insert(particles.end(), list.begin(), list.end());
  return particles;
}

template <int D>
void expect_like_twin(bool plain) {
  const auto parameters = thermal_room<D>(plain);
  auto store = crowd<D>();
  RefusableMotion<D> motion(parameters, box<D>());
  RoomForFew<D> rule;
  for (std::uint64_t step = 0; step < 10; ++step) {
    const MotionStep now{0.2, 0, wall_key(step)};
    const auto expected = refused_by_hand<D>(store, parameters, now);
    std::vector<std::uint32_t> held;
    for (std::uint32_t cell = 0; cell < store.grid().size(); ++cell)
      held.push_back(std::max(kMost, store.offsets()[cell + 1] - store.offsets()[cell]));
    motion.advance(store, now, rule);
    store.sort();
    ASSERT_TRUE(std::ranges::equal(store.phases(), expected, same<D>)) << "step " << step;
    for (std::uint32_t cell = 0; cell < store.grid().size(); ++cell)
      ASSERT_LE(store.offsets()[cell + 1] - store.offsets()[cell], held[cell]);
  }
  EXPECT_GT(rule.refused, 300);
}

TEST(RefusableMotion, RefusesLikeItsTwin) {
  for (const bool plain : {true, false}) {
    expect_like_twin<2>(plain);
    expect_like_twin<3>(plain);
  }
}

/// A rule that refuses nothing leaves the motion as it is, planes included.
template <int D>
void expect_like_motion(bool plain) {
  auto parameters = thermal_room<D>(plain);
  std::vector<Plane> planes{{1, 0.8, {-5, 0, 5}}}, more = planes;
  auto free = crowd<D>(), asked = crowd<D>();
  parameters.planes = &planes;
  const auto stage = make_motion_stage<D>(parameters, box<D>());
  parameters.planes = &more;
  RefusableMotion<D> motion(parameters, box<D>());
  NoRule<D> rule;
  for (std::uint64_t step = 0; step < 5; ++step) {
    const MotionStep now{0.2, 0, wall_key(step)};
    advance(*stage, free, now);
    free.sort();
    motion.advance(asked, now, rule);
    asked.sort();
    ASSERT_TRUE(std::ranges::equal(free.phases(), asked.phases(), same<D>));
    ASSERT_TRUE(std::ranges::equal(free.offsets(), asked.offsets()));
  }
  EXPECT_GT(planes[0].up(), 100);
  EXPECT_EQ(planes[0].up(), more[0].up());
  EXPECT_EQ(planes[0].down(), more[0].down());
}

TEST(RefusableMotion, WithoutRefusalIsTheMotion) {
  for (const bool plain : {true, false}) {
    expect_like_motion<2>(plain);
    expect_like_motion<3>(plain);
  }
}

/// Who stays keeps all that it has, and no plane counts it.
TEST(RefusableMotion, RefusedParticlesKeepPlaceAndVelocity) {
  class Nobody final : public EntryRule<3> {
    void decide(const Proposals<3>& moves) override { std::ranges::fill(moves.refused, 1); }
  } rule;
  auto parameters = thermal_room<3>(false);
  std::vector<Plane> planes{{1, 0.8, {-5, 0, 5}}};
  parameters.planes = &planes;
  auto store = crowd<3>();
  const std::vector<Phase<3>> before(store.phases().begin(), store.phases().end());
  RefusableMotion<3>(parameters, box<3>()).advance(store, {0.5}, rule);
  store.sort();
  EXPECT_TRUE(std::ranges::equal(store.phases(), before, same<3>));
  EXPECT_EQ(planes[0].up() + planes[0].down(), 0);
}

using Blocks = std::vector<std::pair<std::size_t, std::size_t>>;

/// Targets, and the particles after a step that refuses some.
std::pair<std::vector<std::uint32_t>, std::vector<Phase<3>>> fly_in(const Blocks& blocks) {
  const auto stage = make_refusable_stage<3>(thermal_room<3>(false), box<3>());
  const MotionStep step{0.3, 0, wall_key(3)};
  auto store = crowd<3>();
  std::vector<std::uint32_t> targets(store.size());
  std::vector<Phase<3>> arrived(store.size() + 1);
  std::vector<std::uint8_t> refused(store.size());
  for (const auto& [first, last] : blocks)
    stage->propose(store, first, last, step, targets.data(), arrived.data());
  for (std::size_t i = 0; i < refused.size(); ++i) refused[i] = i % 5 == targets[i] % 5;
  for (const auto& [first, last] : blocks)
    stage->advance_accepted(store, first, last, step, refused.data(), arrived.data());
  return {targets, {store.phases().begin(), store.phases().end()}};
}

/// Both passes take their blocks in any order.
TEST(RefusableMotion, OrderOfBlocksCannotShow) {
  const auto forth = fly_in({{0, 300}, {300, 1100}, {1100, 2000}}), back = fly_in({{900, 2000}, {0, 900}});
  EXPECT_EQ(forth.first, back.first);
  EXPECT_TRUE(std::ranges::equal(forth.second, back.second, same<3>));
}

}  // namespace
}  // namespace sandglass::motion

#include "sim/method/event_driven/agents_by_cell.hpp"

#include "sim/method/event_driven/check_codes.hpp"
#include "sim/method/event_driven/test_gas.hpp"

#include <gmock/gmock.h>

namespace sandglass::event_driven::agents_by_cell_test {
namespace {

template <int D>
std::vector<std::uint32_t> all_cells(const Cells<D>& cells) {
  std::vector<std::uint32_t> all;
  const Box<D> box = Box<D>::everywhere();
  cells.for_each_between(box.low, box.high, [&](std::uint32_t cell) { all.push_back(cell); });
  return all;
}

/// Walls at rest and in motion, planes at edges of cells and elsewhere, a timer, obstacles from a particle's size to a
/// third of the box.
template <int D>
Agents<D> some_agents(const Vector<D>& box, std::vector<Plane>& planes) {
  Agents<D> agents;
  const Vector<D> none = Vector<D>::Zero();
  for (const double speed : {0.0, 0.1})
    for (const bool high : {false, true}) {
      WallPlace<D> place{0, high, high ? box[0] : 0.0, speed * Vector<D>::Unit(0), 0.2, 1, 0.5};
      agents.push_back(std::make_unique<WallAgent<D>>(place, WallRule{}, none));
    }
  const auto nothing = [](ParticleAccess<D>&, double) {};
  agents.push_back(std::make_unique<TimerAgent<D, decltype(nothing)>>(1, 1, nothing));
  planes.assign({Plane(1, 0, {0, 1}), Plane(1, 2, {0, 1}), Plane(1, 3.7, {0, 1})});
  for (Plane& plane : planes) agents.push_back(std::make_unique<PlaneAgent<D>>(&plane, none));
  Random random(StreamKey(3, Purpose::positions, 0, 0), 0);
  for (int k = 0; k < 60; ++k) {
    Vector<D> centre;
    for (int axis = 0; axis < D; ++axis) centre[axis] = box[axis] * random.uniform();
    const double radius = k < 5 ? box[0] / 3 * random.uniform() : random.uniform();
    agents.push_back(std::make_unique<ObstacleAgent<D>>(centre, radius, WallRule{}, none, 0.5));
  }
  return agents;
}

/// The slow twin asks every agent about every cell.
template <int D>
void expect_rows_as_asked() {
  const Vector<D> box = Vector<D>::Constant(14);
  Geometry<D> geometry{box, {}};
  geometry.periodic[1] = true;
  const Cells<D> cells(geometry, 1.9);
  std::vector<Plane> planes;
  const Agents<D> agents = some_agents<D>(box, planes);
  const AgentsByCell<D> rows(cells, agents);
  ASSERT_EQ(all_cells(cells).size(), cells.size());
  for (const std::uint32_t cell : all_cells(cells)) {
    std::vector<std::uint32_t> expected;
    const Box<D> edges{cells.low_corner(cell), cells.high_corner(cell)};
    for (std::uint32_t a = 0; a < agents.size(); ++a)
      if (agents[a]->reach().overlaps(edges) && agents[a]->reaches(edges)) expected.push_back(a);
    const auto row = rows[cells.linear(cell)];
    ASSERT_EQ(std::vector(row.begin(), row.end()), expected) << cell;
  }
}

TEST(AgentsByCell, HoldsThoseThatReachACell) {
  expect_rows_as_asked<2>();
  expect_rows_as_asked<3>();
}

TEST(AgentsByCell, IsEmptyWhenNobodyActsOnParticles) {
  const Cells<2> cells({Vector<2>(10, 10), {true, true}}, 1);
  EXPECT_TRUE(AgentsByCell<2>(cells, {}).empty());
  const auto nothing = [](ParticleAccess<2>&, double) {};
  Agents<2> timers;
  timers.push_back(std::make_unique<TimerAgent<2, decltype(nothing)>>(1, 1, nothing));
  EXPECT_TRUE(AgentsByCell<2>(cells, timers).empty());
}

TEST(Codes, MoreThanNumbersCanNameAreRefused) {
  const std::uint64_t half = std::uint64_t{1} << 31;
  EXPECT_NO_THROW(check_codes(half, half - 1));
  EXPECT_THROW(check_codes(half + 1, 0), InputError);
  EXPECT_THROW(check_codes(0, half), InputError);
}

}  // namespace
}  // namespace sandglass::event_driven::agents_by_cell_test

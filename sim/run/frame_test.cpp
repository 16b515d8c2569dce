#include "sim/run/frame.hpp"

#include "sim/method/dsmc/dsmc.hpp"
#include "sim/record/scratch.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace sandglass::frame_test {
namespace {

/// A column that no file but this one knows.
constexpr ColumnKey<Vector<3>> kMadeUp{"made-up", "length time^-3", 0.5};

Vector<3> value_of(std::uint64_t id) {
  const auto x = static_cast<double>(id);
  return {x, x / 3, -x * x};
}

dsmc::Dsmc<2> gas() {
  return dsmc::Dsmc<2>(Grid<2>(Vector<2>(4, 4), {4, 4}), {}, {}, {}, Purpose::collisions,
                       {column::id, kMadeUp});
}

Particles<2> start() {
  Random random(StreamKey(2, Purpose::positions, 0, 0), 0);
  Particles<2> particles;
  for (std::uint64_t id = 0; id < 200; ++id) {
    particles.phases.push_back(
        {{4 * random.uniform(), 4 * random.uniform()}, {2 * random.uniform() - 1, 2 * random.uniform() - 1}});
    particles.columns.append(column::id, id);
    particles.columns.append(kMadeUp, value_of(id));
  }
  return particles;
}

Record record_of(std::vector<Frame> frames) {
  Record record;
  record.dimension = 2;
  record.box_size = {4, 4};
  record.boundary = {"periodic", "periodic"};
  record.trajectory = std::move(frames);
  return record;
}

void expect_belongs_to_ids(const ColumnViews& columns, std::size_t count) {
  const auto ids = columns.get(column::id);
  const auto values = columns.get(kMadeUp);
  ASSERT_EQ(ids.size(), count);
  ASSERT_EQ(values.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_EQ(values[i], ids[i] < 200 ? value_of(ids[i]) : Vector<3>(Vector<3>::Constant(0.5)));
}

/// Store, sort, view, frame, file, and back into a store: with its units, and while particles come and go.
TEST(Frame, AMadeUpColumnTravelsTheWholeWay) {
  auto simulation = gas();
  simulation.assign(start());
  for (std::uint64_t step = 0; step < 10; ++step) simulation.step(0.2, step);
  std::vector<Frame> frames{frame_of(simulation.view())};
  const std::vector<std::uint32_t> leaving{0, 17, 150};
  simulation.remove(leaving);
  simulation.insert({{{{1, 1}, {0, 1}}}, {}});
  for (std::uint64_t step = 10; step < 20; ++step) simulation.step(0.2, step);
  frames.push_back(frame_of(simulation.view()));
  expect_belongs_to_ids(simulation.view().columns, 198);

  const ScratchFolder folder;
  write_record(folder / "run.h5", record_of(frames));
  const Record back = read_record(folder / "run.h5");
  ASSERT_EQ(back.trajectory.size(), 2u);
  EXPECT_EQ(back.trajectory[0].particles(2), 200u);
  EXPECT_EQ(back.trajectory[1].columns.find(kMadeUp)->info.units, "length time^-3");
  auto resumed = gas();
  resumed.assign(particles_of<2>(back.trajectory[1]));
  expect_belongs_to_ids(resumed.view().columns, 198);
  const Frame again = frame_of(resumed.view());
  EXPECT_EQ(again.position, frames[1].position);
  EXPECT_EQ(again.velocity, frames[1].velocity);
  EXPECT_TRUE(std::ranges::equal(again.columns.get(kMadeUp), frames[1].columns.get(kMadeUp)));
}

}  // namespace
}  // namespace sandglass::frame_test

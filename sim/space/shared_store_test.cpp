#include "sim/space/shared_store.hpp"

#include "sim/base/particle_columns.hpp"
#include "sim/base/random.hpp"
#include "sim/base/thread_ranks.hpp"

#include <mutex>

#include <gtest/gtest.h>

// One box on several ranks against the slow twin: one process that holds all particles.

namespace sandglass::shared_store_test {
namespace {

template <int D>
Grid<D> grid() {
  std::array<std::uint32_t, D> cells;
  cells.fill(5);
  return {Vector<D>::Constant(1), cells};
}

const std::vector<ColumnInfo> kColumns = {column::id, column::species, column::spin<3>, column::weight};

template <int D>
Particles<D> particles(std::size_t count) {
  Random random(StreamKey(8, Purpose::positions, 0, 0), 0);
  Particles<D> all;
  for (std::size_t i = 0; i < count; ++i) {
    Vector<D> position;
    for (int axis = 0; axis < D; ++axis) position[axis] = random.uniform();
    all.phases.push_back({position, Vector<D>::Constant(static_cast<double>(i))});
    all.columns.append(column::species, static_cast<std::uint8_t>(i % 3));
    all.columns.append(column::spin<3>, Spin<3>::Constant(0.25 * static_cast<double>(i)));
    all.columns.append(column::weight, 1.5 * static_cast<double>(i));
  }
  return all;
}

/// Everyone to a new place, as its identity and the step say; the higher the step, the nearer to the low end of an axis.
/// Every eleventh stays where it is, and one leaves at each step where `leave`.
template <int D>
void move(ParticleStore<D>& store, std::uint64_t step, bool leave) {
  store.begin_step();
  for (std::size_t i = 0; i < store.size(); ++i) {
    const std::uint64_t id = store.ids()[i];
    Random random(StreamKey(9, Purpose::positions, 0, step), id);
    if (id % 11 != 0)
      for (int axis = 0; axis < D; ++axis) store.phases()[i].position[axis] = random.uniform();
    store.phases()[i].position[D - 1] *= std::pow(0.97, static_cast<double>(step));
    const std::uint32_t cell =
        leave && id == 5 * step ? store.removed() : store.cells().cell_of(store.phases()[i].position);
    store.places()[i] = {cell, store.arrivals()[cell]++};
  }
}

struct Options {
  std::size_t particles = 700;
  bool leave = true;
  std::uint64_t steps = 60;
};

template <int D>
bool same(const ParticleStore<D>& a, const ParticleStore<D>& b) {
  if (a.size() != b.size() || !std::ranges::equal(a.offsets(), b.offsets())) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a.phases()[i].position != b.phases()[i].position || a.phases()[i].velocity != b.phases()[i].velocity)
      return false;
  const auto equal = [&](const auto& key) {
    return std::ranges::equal(a.columns().get(key), b.columns().get(key));
  };
  return equal(column::id) && equal(column::species) && equal(column::spin<3>) && equal(column::weight);
}

struct Outcome {
  std::uint64_t differing = 0;  ///< steps
  std::uint64_t cuts_moved = 0;
  std::size_t most = 0;  ///< particles that one rank held at the end
};

template <int D, class Ranks = ThreadCommunicator>
Outcome compare(std::size_t count, const Options& options = {}) {
  Outcome outcome;
  std::mutex guard;
  on_ranks<Ranks>(count, [&](Communicator& ranks) {
    ParticleStore<D> whole(grid<D>(), kColumns), store(grid<D>(), kColumns);
    SharedStore<D> shared(store, kColumns, ranks);
    whole.assign(particles<D>(options.particles));
    store.assign(particles<D>(options.particles));
    shared.keep_own();
    for (std::uint64_t step = 1; step <= options.steps; ++step) {
      const auto cuts = shared.work().cuts();
      move(whole, step, options.leave);
      move(store, step, options.leave);
      whole.sort();
      shared.sort();
      const ParticleStore<D>& all = shared.gather();
      const std::lock_guard lock(guard);
      if (!ranks.is_first()) continue;
      outcome.differing += !same(whole, all);
      outcome.cuts_moved += cuts != shared.work().cuts();
    }
    const std::lock_guard lock(guard);
    outcome.most = std::max(outcome.most, store.size());
  });
  return outcome;
}

TEST(SharedStore, HoldsTheParticlesInTheOrderOfOneProcess) {
  for (const std::size_t ranks : {1, 2, 3, 5}) {
    EXPECT_EQ(compare<2>(ranks).differing, 0u) << ranks;
    EXPECT_EQ(compare<3>(ranks).differing, 0u) << ranks;
  }
}

/// 25 cells.
TEST(SharedStore, RanksWithoutACellAreIdle) {
  EXPECT_EQ(compare<2>(30, {.particles = 40, .steps = 10}).differing, 0u);
  EXPECT_EQ(compare<2>(3, {.particles = 0, .steps = 3}).differing, 0u);
  EXPECT_EQ(compare<2>(3, {.particles = 1, .leave = false, .steps = 10}).differing, 0u);
}

/// In the end nearly all particles stand in the lowest of five slabs of cells.
TEST(SharedStore, CutsFollowTheParticles) {
  const Outcome outcome = compare<3>(2, {.particles = 2000, .leave = false, .steps = 80});
  EXPECT_EQ(outcome.differing, 0u);
  EXPECT_GT(outcome.cuts_moved, 0u);
  EXPECT_LT(outcome.most, 1200u);
}

/// Planted fault: what comes from higher ranks is taken for what comes from lower ones, and the other way round.
class Swapping final : public ThreadCommunicator {
 public:
  using ThreadCommunicator::ThreadCommunicator;
  std::vector<Bytes> exchange(const std::vector<Bytes>& messages) override {
    auto received = ThreadCommunicator::exchange(messages);
    if (rank() > 0 && rank() + 1 < count()) std::swap(received[rank() - 1], received[rank() + 1]);
    return received;
  }
};

/// Planted fault: a message is lost.
class Losing final : public ThreadCommunicator {
 public:
  using ThreadCommunicator::ThreadCommunicator;
  std::vector<Bytes> exchange(const std::vector<Bytes>& messages) override {
    auto received = ThreadCommunicator::exchange(messages);
    if (rank() == 1 && ++calls_ == 7) received[0].clear();
    return received;
  }

 private:
  int calls_ = 0;
};

TEST(SharedStore, TheTwinCatchesAWrongOrderAndALoss) {
  EXPECT_GT((compare<2, Swapping>(3).differing), 50u);
  EXPECT_GT((compare<2, Losing>(2).differing), 50u);
}

}  // namespace
}  // namespace sandglass::shared_store_test

#include "sim/method/dsmc/contact_partners.hpp"

#include "sim/base/error.hpp"
#include "sim/base/statistics.hpp"
#include "sim/physics/collision.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

// Single steps of the collisions over a diameter against sums over all particles and directions. Statistical bounds are 4.5
// standard errors.

namespace sandglass::dsmc::contact_partners_test {
namespace {

constexpr std::uint32_t kCells =
    4;  // along an axis: one more than every third, so that a seam has a colour of its own
constexpr double kEdge = 1.2;  // of a cell, in diameters

template <int D>
struct System {
  Grid<D> grid;
  std::array<bool, D> periodic;
  ParticleStore<D> store{grid};
  std::vector<double> factor{};  ///< by cell; empty without
  Tally tally{};
  std::uint64_t bound_raised = 0;

  double box() const { return grid.box()[0]; }
  CollisionStep<D> step(double coefficient, std::uint64_t number) {
    return {StreamKey(1, Purpose::collisions, 0, number),
            coefficient,
            factor.empty() ? nullptr : factor.data(),
            nullptr,
            0,
            store.phases().data(),
            store.offsets().data(),
            &tally,
            &bound_raised};
  }
};

template <int D>
System<D> empty_system(std::uint32_t cells, double edge, bool walled) {
  std::array<std::uint32_t, D> numbers;
  numbers.fill(cells);
  std::array<bool, D> periodic;
  periodic.fill(true);
  periodic[0] = !walled;
  return {Grid<D>(Vector<D>::Constant(cells * edge), numbers), periodic};
}

/// Of the cells of a checkerboard.
template <int D>
bool taken(std::uint32_t cell) {
  std::uint32_t sum = 0;
  for (int axis = 0; axis < D; ++axis, cell /= kCells) sum += cell % kCells;
  return sum % 2 == 0;
}

/// Walls along the first axis, and every second cell empty, as on a checkerboard. The contact factor is high in the empty
/// cells, where midpoints lie and no particle does.
template <int D>
System<D> checkerboard() {
  System<D> system = empty_system<D>(kCells, kEdge, true);
  Random random(StreamKey(2, Purpose::positions, 0, 0), 0);
  std::vector<Phase<D>> particles;
  while (particles.size() < 150) {
    Phase<D> particle;
    for (int axis = 0; axis < D; ++axis) {
      particle.position[axis] = system.box() * random.uniform();
      particle.velocity[axis] = 2 * random.uniform() - 1;
    }
    if (taken<D>(system.grid.cell_of(particle.position))) particles.push_back(particle);
  }
  system.store.assign({particles, {}});
  for (std::uint32_t cell = 0; cell < system.grid.size(); ++cell)
    system.factor.push_back(taken<D>(cell) ? 1 + random.uniform() : 5 + random.uniform());
  return system;
}

/// Evenly over the circle or sphere.
template <int D>
std::vector<Vector<D>> directions() {
  std::vector<Vector<D>> all;
  constexpr int kCount = D == 2 ? 1000 : 4000;
  for (int i = 0; i < kCount; ++i)
    if constexpr (D == 2) {
      const double angle = 2 * M_PI * (i + 0.5) / kCount;
      all.emplace_back(std::cos(angle), std::sin(angle));
    } else {
      const double z = 1 - (2 * i + 1.0) / kCount, angle = M_PI * (3 - std::sqrt(5.0)) * i;
      all.emplace_back(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
    }
  return all;
}

/// The cell of a point, across the edges of all axes but the first; the number of cells for one beyond a wall.
template <int D>
std::uint32_t cell_at(const System<D>& system, Vector<D> point) {
  if (point[0] < 0 || point[0] > system.box()) return system.grid.size();
  for (int axis = 1; axis < D; ++axis) point[axis] -= system.box() * std::floor(point[axis] / system.box());
  return system.grid.cell_of(point);
}

/// Half the sum over particles of the mean over directions of chi sum_j (c_ij . k)_+, which times
/// Omega d^(D-1) weight dt / V are the collisions of a step.
template <int D>
double expected_sum(System<D>& system, double place = 0.5) {
  double sum = 0;
  const auto all = directions<D>();
  const auto particles = system.store.phases();
  for (std::uint32_t i = 0; i < particles.size(); ++i)
    for (const Vector<D>& k : all) {
      const std::uint32_t cell = cell_at<D>(system, particles[i].position + k);
      if (cell == system.grid.size()) continue;
      const double chi = system.factor[cell_at<D>(system, particles[i].position + place * k)];
      for (std::uint32_t j = system.store.offsets()[cell]; j < system.store.offsets()[cell + 1]; ++j)
        if (j != i) sum += chi * std::max(0.0, (particles[i].velocity - particles[j].velocity).dot(k));
    }
  return 0.5 * sum / static_cast<double>(all.size());
}

/// Directions of the circle or sphere over the cross-section, both of diameter one.
template <int D>
constexpr double kDirections = D == 2 ? M_PI : 4;

/// Particles that pass through each other, so that the rate stays what it is.
Parameters transparent(double contact_place = 0.5) {
  Parameters parameters;
  parameters.restitution = -1;
  parameters.faults.contact_place = contact_place;
  return parameters;
}

template <int D>
Mean counted(const Parameters& parameters, double coefficient) {
  System<D> system = checkerboard<D>();
  ContactPartners<D> contact(parameters, system.grid, system.periodic);
  std::vector<double> counts;
  for (std::uint64_t number = 0; number < 1500; ++number) {
    system.tally.collisions = 0;
    contact.collide(system.step(coefficient, number));
    counts.push_back(static_cast<double>(system.tally.collisions));
  }
  return mean_of_independent(counts);
}

template <int D>
void expect_rate() {
  System<D> system = checkerboard<D>();
  const double coefficient = 0.06, unit = 2 * coefficient * kDirections<D>;
  const double at_midpoint = unit * expected_sum(system), at_particle = unit * expected_sum(system, 0);
  const Mean honest = counted<D>(transparent(), coefficient), own = counted<D>(transparent(0), coefficient);
  EXPECT_LT(honest.standard_error, 0.004 * honest.value);
  EXPECT_NEAR(honest.value, at_midpoint, 4.5 * honest.standard_error) << D << "D";
  EXPECT_NEAR(own.value, at_particle, 4.5 * own.standard_error) << D << "D, planted fault";
  EXPECT_GT(at_midpoint, 1.05 * at_particle);
}

TEST(ContactPartners, CollideAtTheRateOfEnskogsTerm) {
  expect_rate<2>();
  expect_rate<3>();
}

/// Two particles in one cell across whose edges they see each other: no place matters, only velocities do.
template <int D>
System<D> pair(bool walled = false) {
  System<D> system = empty_system<D>(1, 2, walled);
  system.store.assign(
      {{{Vector<D>::Zero(), Vector<D>::Unit(0)}, {Vector<D>::Zero(), -Vector<D>::Unit(0)}}, {}});
  return system;
}

/// Changes of the first velocity in steps with one candidate at most.
template <int D>
std::vector<Vector<D>> kicks(const Parameters& parameters, double* transfer = nullptr) {
  std::vector<Vector<D>> all;
  ContactPartners<D> contact(parameters, pair<D>().grid, pair<D>().periodic);
  for (std::uint64_t number = 0; number < 100'000; ++number) {
    System<D> system = pair<D>();
    // Candidates: kDirections * coefficient * two particles * two in the cell * relative speed two.
    contact.collide(system.step(0.9 / (8 * kDirections<D>), number));
    if (system.tally.collisions == 0) continue;
    all.push_back(system.store.phases()[0].velocity - Vector<D>::Unit(0));
    EXPECT_LT((system.store.phases()[0].velocity + system.store.phases()[1].velocity).norm(), 1e-15);
    if (transfer != nullptr) *transfer += system.tally.transfer.value();
  }
  return all;
}

/// Lines of centres weighted with the flux: uniform in the impact parameter b (2D) or in b^2 (3D).
template <int D>
void expect_flux_weighted_lines() {
  constexpr std::size_t kBins = 20;
  std::array<double, kBins> count{};
  Vector<D> across = Vector<D>::Zero();
  const auto all = kicks<D>({});
  ASSERT_GT(all.size(), 10'000u);
  for (const Vector<D>& kick : all) {
    const Vector<D> line = kick.normalized();
    EXPECT_LE(line[0], 0);
    const double square = std::max(0.0, 1 - line[0] * line[0]);
    ++count[std::min(kBins - 1, static_cast<std::size_t>(kBins * (D == 2 ? std::sqrt(square) : square)))];
    across += line;
  }
  const auto total = static_cast<double>(all.size());
  double chi_square = 0;
  for (const double number : count) chi_square += std::pow(number - total / kBins, 2) / (total / kBins);
  EXPECT_LT(chi_square, 19 + 4.5 * std::sqrt(2 * 19.0));
  for (int axis = 1; axis < D; ++axis) EXPECT_LT(std::abs(across[axis]), 4.5 * std::sqrt(total / 2));
}

TEST(ContactPartners, LinesOfCentresAreWeightedWithTheFlux) {
  expect_flux_weighted_lines<2>();
  expect_flux_weighted_lines<3>();
}

/// m d (1 + r)/2 |c_n| a collision: the momentum m |kick| over a diameter.
TEST(ContactPartners, CarryTheHardCoreVirial) {
  Parameters parameters;
  parameters.restitution = 0.8;
  parameters.mass = 1.5;
  parameters.measure_transfer = true;
  double transfer = 0, expected = 0;
  for (const Vector<3>& kick : kicks<3>(parameters, &transfer)) expected += 1.5 * kick.norm();
  EXPECT_NEAR(transfer / expected, 1, 1e-12);
  parameters.faults.reach = 0.5;  // the planted fault carries half of it
  double half = 0, expected_of_fault = 0;
  for (const Vector<3>& kick : kicks<3>(parameters, &half)) expected_of_fault += 1.5 * kick.norm();
  EXPECT_NEAR(half / expected_of_fault, 0.5, 1e-12);
}

/// At a wall half of all points lie beyond it.
template <int D>
void expect_half_the_rate_at_a_wall() {
  std::vector<double> free, walled;
  for (const bool wall : {false, true}) {
    System<D> system = pair<D>(wall);
    ContactPartners<D> contact(transparent(), system.grid, system.periodic);
    for (std::uint64_t number = 0; number < 50'000; ++number) {
      system.tally.collisions = 0;
      contact.collide(system.step(0.05, number));
      (wall ? walled : free).push_back(static_cast<double>(system.tally.collisions));
    }
  }
  const Mean all = mean_of_independent(free), half = mean_of_independent(walled);
  EXPECT_LT(half.standard_error, 0.02 * half.value);
  EXPECT_NEAR(half.value, all.value / 2, 4.5 * std::hypot(half.standard_error, all.standard_error / 2));
}

TEST(ContactPartners, NobodyStandsBeyondAWall) {
  expect_half_the_rate_at_a_wall<2>();
  expect_half_the_rate_at_a_wall<3>();
}

template <int D>
void expect_conservation(double restitution) {
  System<D> system = checkerboard<D>();
  const auto sums = [&system] {
    Vector<D> momentum = Vector<D>::Zero();
    double energy = 0;
    for (const Phase<D>& particle : system.store.phases()) {
      momentum += particle.velocity;
      energy += particle.velocity.squaredNorm();
    }
    return std::pair(momentum, energy);
  };
  Parameters parameters;
  parameters.restitution = restitution;
  const auto before = sums();
  ContactPartners<D>(parameters, system.grid, system.periodic).collide(system.step(0.3, 0));
  const auto after = sums();
  EXPECT_GT(system.tally.collisions, 100u);
  EXPECT_LT((after.first - before.first).norm(), 1e-12);
  if (restitution == 1)
    EXPECT_NEAR(after.second / before.second, 1, 1e-13);
  else
    EXPECT_LT(after.second, before.second);
}

TEST(ContactPartners, KeepMomentumAndElasticEnergy) {
  expect_conservation<2>(1);
  expect_conservation<3>(1);
  expect_conservation<2>(0.6);
  expect_conservation<3>(0.6);
}

template <int D>
bool same(const Phase<D>& a, const Phase<D>& b) {
  return a.position == b.position && a.velocity == b.velocity;
}

/// A whole step, and the cells of each colour backwards.
template <int D>
void expect_order_to_be_no_matter() {
  Parameters parameters;
  parameters.restitution = 0.7;
  parameters.measure_transfer = true;
  System<D> forwards = checkerboard<D>(), backwards = checkerboard<D>();
  ContactPartners<D> one(parameters, forwards.grid, forwards.periodic),
      two(parameters, forwards.grid, forwards.periodic);
  for (std::uint64_t number = 0; number < 5; ++number) {
    one.collide(forwards.step(0.2, number));
    const CollisionStep<D> step = backwards.step(0.2, number);
    two.begin(step);
    for (auto cells : two.colours()) {
      std::ranges::reverse(cells);
      two.collide(step, cells);
    }
  }
  EXPECT_GT(forwards.tally.collisions, 300u);
  EXPECT_EQ(forwards.tally.candidates, backwards.tally.candidates);
  EXPECT_EQ(forwards.tally.transfer.value(), backwards.tally.transfer.value());
  EXPECT_TRUE(std::ranges::equal(forwards.store.phases(), backwards.store.phases(), same<D>));
}

/// A lone particle finds its partners in a crowded cell as often as each of them finds it.
TEST(ContactPartners, ALoneParticleBesideACrowdCollidesAtItsRate) {
  System<2> system = empty_system<2>(3, kEdge, true);
  std::vector<Phase<2>> particles = {{{0.6, 1.8}, {1, 0}}};
  for (int i = 0; i < 20; ++i) particles.push_back({{1.8, 1.8}, {0, 0}});
  system.store.assign({particles, {}});
  system.factor.assign(system.grid.size(), 1);
  const double coefficient = 0.02, expected = 2 * coefficient * kDirections<2> * expected_sum(system);
  ContactPartners<2> contact(transparent(), system.grid, system.periodic);
  std::vector<double> counts;
  for (std::uint64_t number = 0; number < 20'000; ++number) {
    system.tally.collisions = 0;
    contact.collide(system.step(coefficient, number));
    counts.push_back(static_cast<double>(system.tally.collisions));
  }
  const Mean counted = mean_of_independent(counts);
  EXPECT_LT(counted.standard_error, 0.02 * counted.value);
  EXPECT_NEAR(counted.value, expected, 4.5 * counted.standard_error);
}

/// Who has been made fast by one side must not surprise the cell on the other: candidates follow the new velocity.
TEST(ContactPartners, NeighboursSeeWhatACollisionHasMadeFast) {
  std::uint64_t collisions = 0;
  for (std::uint64_t number = 0; number < 200; ++number) {
    System<2> system = empty_system<2>(1, kEdge, true);
    system.grid = Grid<2>({3 * kEdge, kEdge}, {3, 1});
    system.store = ParticleStore<2>(system.grid);
    system.store.assign({{{{0.6, 0.6}, {1, 0}}, {{1.8, 0.6}, {0, 0}}, {{3, 0.6}, {0, 0}}}, {}});
    ContactPartners<2> contact({}, system.grid, system.periodic);
    const std::uint32_t left = 0, right = 2;
    contact.begin(system.step(0.3, number));
    contact.collide(system.step(0.3, number), {&left, 1});
    collisions += system.tally.collisions;
    const std::uint64_t before = system.tally.candidates;
    const double speed = system.store.phases()[1].velocity.norm();
    contact.collide(system.step(1000, number), {&right, 1});
    ASSERT_GE(static_cast<double>(system.tally.candidates - before),
              std::floor(1000 * kDirections<2> * speed * (1 - 1e-12)));
  }
  EXPECT_GT(collisions, 10u);
}

TEST(ContactPartners, OrderOfTheCellsOfAColourIsNoMatter) {
  expect_order_to_be_no_matter<2>();
  expect_order_to_be_no_matter<3>();
}

TEST(ContactPartners, RefuseCellsNarrowerThanADiameter) {
  EXPECT_THROW(ContactPartners<2>({}, Grid<2>({4, 4}, {4, 5}), {true, true}), InputError);
  EXPECT_NO_THROW(ContactPartners<2>({}, Grid<2>({4, 5}, {4, 5}), {true, true}));
}

}  // namespace
}  // namespace sandglass::dsmc::contact_partners_test

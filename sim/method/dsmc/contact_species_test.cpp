#include "sim/base/error.hpp"
#include "sim/base/statistics.hpp"
#include "sim/method/dsmc/contact_partners.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

// Collisions over a diameter of several species against sums over all particles and directions. Statistical bounds are 4.5
// standard errors.

namespace sandglass::dsmc::contact_species_test {
namespace {

constexpr std::uint32_t kCells = 3;
constexpr double kEdge = 1.2;
constexpr std::size_t kSpecies = 2, kPairs = kSpecies * kSpecies;

Parameters two_species(double restitution) {
  Parameters parameters;
  parameters.kinds.species = {{0.5, 1}, {1, 3}};
  parameters.kinds.surfaces.assign(kPairs, Surface{});
  for (Surface& surface : parameters.kinds.surfaces) surface.normal.value = restitution;
  parameters.measure_transfer = true;
  return parameters;
}

/// A crowd at random in a periodic box, with contact factors of each cell and pair.
template <int D>
struct Crowd {
  Grid<D> grid{Vector<D>::Constant(kCells * kEdge), [] {
                 std::array<std::uint32_t, D> cells;
                 cells.fill(kCells);
                 return cells;
               }()};
  ParticleStore<D> store{grid, {column::species}};
  std::vector<double> factor, contact;
  Tally tally{};
  std::uint64_t bound_raised = 0;

  Crowd() {
    Random random(StreamKey(2, Purpose::positions, 0, 0), 0);
    Particles<D> all;
    std::vector<std::uint8_t> species;
    for (int i = 0; i < 60; ++i) {
      Phase<D> particle;
      for (int axis = 0; axis < D; ++axis) {
        particle.position[axis] = grid.box()[axis] * random.uniform();
        particle.velocity[axis] = 2 * random.uniform() - 1;
      }
      all.phases.push_back(particle);
      species.push_back(i % 3 == 0);
    }
    all.columns.set(column::species, species);
    store.assign(all);
    for (std::uint32_t cell = 0; cell < grid.size(); ++cell) {
      factor.push_back(1 + random.uniform());
      const double mixed = random.uniform();
      contact.insert(contact.end(), {random.uniform(), mixed, mixed, 1});
    }
    tally.by_species.resize(kPairs);
  }

  const std::uint8_t* species() { return store.column(column::species).data(); }
  CollisionStep<D> step(double coefficient, std::uint64_t number) {
    return {StreamKey(1, Purpose::collisions, 0, number),
            coefficient,
            factor.data(),
            nullptr,
            0,
            store.phases().data(),
            store.offsets().data(),
            &tally,
            &bound_raised,
            species(),
            nullptr,
            contact.data()};
  }
  std::uint32_t cell_at(Vector<D> point) const {
    for (int axis = 0; axis < D; ++axis)
      point[axis] -= grid.box()[axis] * std::floor(point[axis] / grid.box()[axis]);
    return grid.cell_of(point);
  }
};

template <int D>
std::vector<Vector<D>> directions() {
  std::vector<Vector<D>> all;
  constexpr int kCount = D == 2 ? 2000 : 4000;
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

/// Collisions of a step that first particles of one species begin with those of another: Enskog's term, over the directions
/// of a cross-section of diameter one.
template <int D>
std::array<double, kPairs> expected(Crowd<D>& crowd, const Parameters& parameters, double coefficient) {
  std::array<double, kPairs> sums{};
  const auto all = directions<D>();
  const auto particles = crowd.store.phases();
  const std::uint8_t* species = crowd.species();
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (const Vector<D>& k : all)
      for (std::uint8_t kind = 0; kind < kSpecies; ++kind) {
        const std::size_t pair = species[i] * kSpecies + kind;
        const double reach =
            (parameters.kinds.species[species[i]].diameter + parameters.kinds.species[kind].diameter) / 2;
        const std::uint32_t cell = crowd.cell_at(particles[i].position + reach * k),
                            middle = crowd.cell_at(particles[i].position + reach / 2 * k);
        const double weight =
            std::pow(reach, D - 1) * crowd.factor[middle] * crowd.contact[middle * kPairs + pair];
        for (std::uint32_t j = crowd.store.offsets()[cell]; j < crowd.store.offsets()[cell + 1]; ++j)
          if (j != i && species[j] == kind)
            sums[pair] += weight * std::max(0.0, (particles[i].velocity - particles[j].velocity).dot(k));
      }
  for (double& sum : sums) sum *= coefficient * (D == 2 ? M_PI : 4) / static_cast<double>(all.size());
  return sums;
}

/// Particles that pass through each other, so that the rate stays what it is.
template <int D>
void expect_rates() {
  Crowd<D> crowd;
  const Parameters parameters = two_species(-1);
  ContactPartners<D> contact(parameters, crowd.grid, [] {
    std::array<bool, D> all;
    all.fill(true);
    return all;
  }());
  constexpr double kCoefficient = 0.15;
  std::array<std::vector<double>, kPairs> counts;
  for (std::uint64_t number = 0; number < 4000; ++number) {
    std::ranges::fill(crowd.tally.by_species, 0u);
    contact.collide(crowd.step(kCoefficient, number));
    for (std::size_t pair = 0; pair < kPairs; ++pair)
      counts[pair].push_back(static_cast<double>(crowd.tally.by_species[pair]));
  }
  const auto all = expected(crowd, parameters, kCoefficient);
  for (std::size_t pair = 0; pair < kPairs; ++pair) {
    const Mean counted = mean_of_independent(counts[pair]);
    EXPECT_LT(counted.standard_error, 0.025 * counted.value);
    EXPECT_NEAR(counted.value, all[pair], 4.5 * counted.standard_error) << D << "D, pair " << pair;
  }
}

TEST(ContactPartners, CollideEachPairOfSpeciesAtItsRate) {
  expect_rates<2>();
  expect_rates<3>();
}

/// Each collision hands over as much as it takes, and the virial is that of mean diameters.
template <int D>
void expect_conservation() {
  Crowd<D> crowd;
  const Parameters parameters = two_species(1);
  std::array<bool, D> periodic;
  periodic.fill(true);
  const auto sums = [&] {
    std::pair<Vector<D>, double> sum{Vector<D>::Zero(), 0};
    for (std::size_t i = 0; i < crowd.store.size(); ++i) {
      const double mass = parameters.kinds.species[crowd.species()[i]].mass;
      const Vector<D>& velocity = crowd.store.phases()[i].velocity;
      sum.first += mass * velocity;
      sum.second += mass * velocity.squaredNorm();
    }
    return sum;
  };
  const auto before = sums();
  ContactPartners<D>(parameters, crowd.grid, periodic).collide(crowd.step(0.8, 0));
  const auto after = sums();
  EXPECT_GT(crowd.tally.collisions, 30u);
  EXPECT_LT((after.first - before.first).norm(), 1e-12);
  EXPECT_NEAR(after.second / before.second, 1, 1e-13);
  EXPECT_GT(crowd.tally.transfer.value(), 0);
}

TEST(ContactPartners, OfSeveralSpeciesKeepMomentumAndEnergy) {
  expect_conservation<2>();
  expect_conservation<3>();
}

TEST(ContactPartners, CellsAreAsWideAsTheWidestSpecies) {
  EXPECT_THROW(ContactPartners<2>(two_species(1), Grid<2>({4, 4}, {4, 5}), {true, true}), InputError);
  EXPECT_NO_THROW(ContactPartners<2>(two_species(1), Grid<2>({4, 4}, {4, 4}), {true, true}));
}

}  // namespace
}  // namespace sandglass::dsmc::contact_species_test

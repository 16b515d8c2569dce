#include "validation/law/heap.hpp"

#include "sim/base/error.hpp"
#include "validation/check/check.hpp"
#include "validation/check/heap_profile.hpp"
#include "validation/check/synthetic.hpp"

#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <gtest/gtest.h>

// Each check of a heap sees surfaces drawn from the law, and surfaces that are not that of a heap.

namespace sandglass::heap_test {
namespace {

using namespace synthetic;

constexpr double kLength = 200;
constexpr law::Heap kHeap{.height = 40, .slope = 0.5, .kink_length = 6};

/// A heap under a source in the middle of the box that has poured 1000 particles at time 1000.
Record heap_record(std::size_t replicas, const std::string& sides = "specular") {
  Record record;
  record.scene = fmt::format(
      "run.duration.time = 1200.0\n[domain]\ndimension = 2\nsize = [{}, 100.0]\n"
      "sides = {{ x = \"{}\", y = \"specular\" }}\n[[species]]\ncount = 0\n"
      "[[source]]\nrate = 1.0\ncount = 1000\nheight = 5.0\ncentre = [100.0]\nvelocity = [0.0, -3.0]\n"
      "[method]\npreset = \"hsmc\"\ncell-size = 2.0\ntime-step = 0.2\n[forces]\ngravity = [0.0, -1.0]\n",
      kLength, sides);
  record.replicas.resize(replicas);
  return record;
}

using Surface = std::function<double(double time, double x)>;

/// Samples at 250, 500, 750, 1000 and 1200 in bins of width 1, with noise of 0.3.
Record surfaces(const Surface& surface, std::size_t replicas = 8, const std::string& sides = "specular") {
  Record record = heap_record(replicas, sides);
  Generator generator(11);
  std::normal_distribution<double> noise(0, 0.3);
  for (std::size_t replica = 0; replica < replicas; ++replica) {
    Series& series = add_series(record, replica, "free-surface", {});
    series.quantity.shape = {200};
    for (const double time : {250.0, 500.0, 750.0, 1000.0, 1200.0}) {
      std::vector<double> heights;
      for (int bin = 0; bin < 200; ++bin) {
        const double h = surface(time, bin + 0.5 - 100);
        heights.push_back(h > 0 ? std::max(0.0, h + noise(generator)) : 0);
      }
      add_sample(series, time, heights);
    }
  }
  return record;
}

/// Grows as the law says: the area with the number of particles.
double growing(double time, double x) {
  law::Heap heap = kHeap;
  heap.height =
      law::heap_height(law::heap_area(kHeap) * std::min(time / 1000, 1.0), heap.slope, heap.kink_length);
  return law::heap_surface(heap, x);
}

double flat(double time, double) { return 5 * std::min(time / 1000, 1.0); }

Evidence evidence_of(const std::string& check, const Record& record, const law::Arguments& numbers = {}) {
  return run_check(find_check(check), record, {numbers, 0, 0, ""});
}

/// In standard errors, positive on the right side of a bound.
double above(const Evidence& evidence) {
  return (evidence.value - evidence.expected) / evidence.standard_error;
}

TEST(HeapProfile, MomentsOfATriangle) {
  HeapProfile profile;
  profile.bin = 0.1;
  for (double x = -100; x <= 100; x += 0.1) {
    profile.x.push_back(x);
    profile.h.push_back(std::max(0.0, 30 - 0.5 * std::abs(x)));
  }
  EXPECT_NEAR(profile.area(), 1800, 1);
  EXPECT_NEAR(profile.height(), 30, 0.01);
  EXPECT_NEAR(profile.half_base(), 60, 0.1);
  EXPECT_NEAR(heap_side_slope(profile, -1, 10, 50), 0.5, 1e-9);
  EXPECT_NEAR(heap_slope(profile, 10, 50), 0.5, 1e-9);
  EXPECT_TRUE(std::isnan(heap_slope(profile, 10, 10.05)));
}

/// One that falls stands over the source in every sample, one that rebounds over a bin in one sample of three.
TEST(HeapProfile, LeavesOutWhoIsInFlight) {
  Record record = heap_record(1);
  Series& series = add_series(record, 0, "free-surface", {});
  series.quantity.shape = {200};
  for (const double time : {490.0, 500.0, 510.0}) {
    std::vector<double> heights(200, 10.0);
    heights[100] = 25;
    heights[static_cast<std::size_t>(time / 5)] = 20;
    add_sample(series, time, heights);
  }
  const std::size_t replica = 0;
  EXPECT_EQ(heap_profile(Subject(record), 1, std::span(&replica, 1)).h, std::vector<double>(200, 10.0));
}

TEST(HeapSlope, FindsTheSlopeAndMissesItInALayer) {
  const Evidence heap = evidence_of("heap-slope", surfaces(growing), {{"least", 0.15}});
  EXPECT_GT(above(heap), 10);
  EXPECT_NEAR(heap.value, 0.4, 0.06);  // m less what the kinks take
  EXPECT_LT(above(evidence_of("heap-slope", surfaces(flat), {{"least", 0.15}})), -10);
}

TEST(HeapSlope, StandsOnACurveOrBesideIt) {
  const double slope = evidence_of("heap-slope", surfaces(growing), {{"least", 0.15}}).value;
  const auto beside = [&](double expected) {
    return above(evidence_of("heap-slope-curve", surfaces(growing),
                             {{"expected", expected}, {"expected-error", 0.01}}));
  };
  EXPECT_NEAR(beside(slope), 0, 1e-9);
  EXPECT_GT(beside(slope - 0.08), 10);
}

TEST(HeapSlope, OfParticlesOnTheFloorIsNone) {
  const Evidence none =
      evidence_of("heap-slope", surfaces([](double, double) { return 0.0; }), {{"least", 0.15}});
  EXPECT_EQ(none.value, 0);
  EXPECT_EQ(none.standard_error, 0);
}

TEST(HeapGrowth, FollowsTheLargestHeap) {
  const Evidence right = evidence_of("heap-growth", surfaces(growing), {{"least-particles", 250}});
  EXPECT_EQ(right.comparisons, 3);
  EXPECT_LT(std::abs(right.value - 1), 4 * right.standard_error + right.budget.systematic);
  EXPECT_LT(right.standard_error, 0.02);
  EXPECT_LT(right.budget.systematic, 0.06);
  // A fifth fewer particles than the scene says, until the count is reached.
  const auto late = [](double time, double x) { return growing(time < 1000 ? 0.8 * time : time, x); };
  const Evidence wrong = evidence_of("heap-growth", surfaces(late), {{"least-particles", 250}});
  EXPECT_GT(std::abs(wrong.value - 1), 4 * wrong.standard_error + wrong.budget.systematic);
}

/// A layer from wall to wall has not grown, nor has a bare floor.
TEST(HeapGrowth, IsNotThatOfALayer) {
  const Evidence layer = evidence_of("heap-growth", surfaces(flat), {{"least-particles", 500}});
  EXPECT_EQ(layer.value, 0);
  EXPECT_GT(std::abs(layer.value - 1), 4 * layer.standard_error + layer.budget.systematic);
  const Evidence bare =
      evidence_of("heap-growth", surfaces([](double, double) { return 0.0; }), {{"least-particles", 500}});
  EXPECT_EQ(bare.value, 0);
}

TEST(HeapGrowth, RefusesARunWithoutSmallerHeaps) {
  EXPECT_THROW(evidence_of("heap-growth", surfaces(growing), {{"least-particles", 800}}), InputError);
}

TEST(HeapTail, FindsKinksWhereThereAreAndNoneInATriangle) {
  const Evidence kinked = evidence_of("heap-tail", surfaces(growing, 4));
  EXPECT_NEAR(kinked.value, kHeap.kink_length, 4 * kinked.standard_error + 0.5);
  EXPECT_GT(above(kinked), 10);
  const auto triangle = [](double, double x) { return 40 - 0.5 * std::abs(x); };
  EXPECT_LT(above(evidence_of("heap-tail", surfaces(triangle, 4))), -4);
  EXPECT_FALSE(above(evidence_of("heap-tail", surfaces(flat, 4))) > 2);
}

/// Feet that differ from replica to replica: their mean has a tail, none of them has.
TEST(HeapTail, IsNotThatOfTheMean) {
  Record record = surfaces([](double, double) { return 0.0; }, 4);
  for (std::size_t replica = 0; replica < 4; ++replica) {
    std::vector<double>& values = record.replicas[replica].series.front().value;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double x = static_cast<double>(i % 200) + 0.5 - 100;
      values[i] = std::max(0.0, 34 + 4 * static_cast<double>(replica) - 0.5 * std::abs(x));
    }
  }
  EXPECT_LT(evidence_of("heap-tail", record).value, 1);
}

TEST(HeapHead, SeesWhetherItIsFlatter) {
  const law::Arguments numbers{{"least", 0.08}};
  const auto round = [](double, double x) { return 40 - 0.5 * std::hypot(x, 20); };
  EXPECT_GT(above(evidence_of("heap-head", surfaces(round), numbers)), 4);
  const auto pointed = [](double, double x) { return 40 - 0.5 * std::abs(x); };
  EXPECT_LT(above(evidence_of("heap-head", surfaces(pointed), numbers)), -4);
  EXPECT_LT(above(evidence_of("heap-head", surfaces(flat), numbers)), -4);
}

TEST(HeapEdge, SeesTheSurfaceBendDownwards) {
  const auto bent = [](double, double x) { return 40 - 0.002 * x * x - 0.1 * std::abs(x); };
  EXPECT_GT(above(evidence_of("heap-edge", surfaces(bent, 8, "open"))), 4);
  EXPECT_LT(above(evidence_of("heap-edge", surfaces(growing, 8, "open"))), -4);
}

TEST(HeapSpike, MeasuresItsWidthInCells) {
  const auto spike = [](double, double x) { return std::abs(x) < 2 ? 50.0 : 4; };
  const law::Arguments numbers{{"cell", 2}, {"least", 1.5}, {"most", 2.5}};
  EXPECT_EQ(evidence_of("heap-spike", surfaces(spike), numbers).value, 2);
  EXPECT_GT(evidence_of("heap-spike", surfaces(growing), numbers).value, 10);
}

/// A box that holds what was poured, or a share of it.
Record poured(double share) {
  Record record = heap_record(2);
  for (std::size_t replica = 0; replica < 2; ++replica) {
    Series& series = add_series(record, replica, "fields", {});
    series.quantity.shape = {1, 1, 4};
    for (const double time : {250.0, 1000.0, 1200.0})
      add_sample(series, time, {std::floor(share * std::min(time, 1000.0)) / (kLength * 100), 0, 0, 1});
  }
  return record;
}

TEST(SourceRate, CountsWhatWasPoured) {
  const Evidence right = evidence_of("source-rate", poured(1));
  EXPECT_EQ(right.kind, Expectation::at_most);
  EXPECT_NEAR(right.value, 0, 1e-6);
  EXPECT_NEAR(evidence_of("source-rate", poured(0.9)).value, 100, 1);
}

TEST(HeapChecks, AreForHeapsAlone) {
  EXPECT_FALSE(find_check("heap-slope").applies(Subject(record_of({}, 1)).scene()));
  EXPECT_TRUE(find_check("heap-slope").applies(Subject(heap_record(1, "open")).scene()));
  EXPECT_FALSE(find_check("heap-growth").applies(Subject(heap_record(1, "open")).scene()));
  EXPECT_TRUE(find_check("heap-edge").applies(Subject(heap_record(1, "open")).scene()));
  EXPECT_FALSE(find_check("heap-edge").applies(Subject(heap_record(1)).scene()));
}

}  // namespace
}  // namespace sandglass::heap_test

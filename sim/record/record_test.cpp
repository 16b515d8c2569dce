#include "sim/record/record.hpp"

#include "sim/base/error.hpp"
#include "sim/record/sample.hpp"
#include "sim/record/scratch.hpp"

#include <cstring>
#include <thread>

#include <gtest/gtest.h>
#include <mpi.h>

namespace sandglass {
namespace {

/// Compares representations, so that NaN equals NaN and -0 differs from 0.
template <class T>
void expect_same_bits(const std::vector<T>& one, const std::vector<T>& other) {
  ASSERT_EQ(one.size(), other.size());
  if (one.empty()) return;
  EXPECT_EQ(std::memcmp(one.data(), other.data(), one.size() * sizeof(T)), 0);
}

void expect_same(const Quantity& one, const Quantity& other) {
  EXPECT_EQ(one.name, other.name);
  EXPECT_EQ(one.units, other.units);
  EXPECT_EQ(one.summary, other.summary);
  EXPECT_EQ(one.shape, other.shape);
  EXPECT_EQ(one.components, other.components);
  EXPECT_EQ(one.axis, other.axis);
  EXPECT_EQ(one.axis_label, other.axis_label);
}

void expect_same(const std::vector<Series>& one, const std::vector<Series>& other) {
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t index = 0; index < one.size(); ++index) {
    expect_same(one[index].quantity, other[index].quantity);
    expect_same_bits(one[index].step, other[index].step);
    expect_same_bits(one[index].time, other[index].time);
    expect_same_bits(one[index].value, other[index].value);
  }
}

void expect_same(const Frame& one, const Frame& other) {
  EXPECT_EQ(one.step, other.step);
  EXPECT_EQ(one.time, other.time);
  expect_same_bits(one.position, other.position);
  expect_same_bits(one.velocity, other.velocity);
  expect_same_bits(one.id, other.id);
  expect_same_bits(one.spin, other.spin);
}

void expect_same(const State& one, const State& other) {
  EXPECT_EQ(one.step, other.step);
  EXPECT_EQ(one.time, other.time);
  expect_same(one.particles, other.particles);
  expect_same(one.series, other.series);
  EXPECT_EQ(one.counters, other.counters);
  ASSERT_EQ(one.memory.size(), other.memory.size());
  for (const auto& [name, values] : one.memory) expect_same_bits(values, other.memory.at(name));
}

void expect_same(const Estimate& one, const Estimate& other) {
  expect_same(one.quantity, other.quantity);
  expect_same_bits(one.value, other.value);
  expect_same_bits(one.standard_error, other.standard_error);
  EXPECT_EQ(one.effective_samples, other.effective_samples);
}

void expect_same(const Provenance& one, const Provenance& other) {
  EXPECT_EQ(one.program_version, other.program_version);
  EXPECT_EQ(one.commit, other.commit);
  EXPECT_EQ(one.build, other.build);
  EXPECT_EQ(one.created, other.created);
  EXPECT_EQ(one.mutation, other.mutation);
}

void expect_same(const Record& one, const Record& other) {
  EXPECT_EQ(one.scene, other.scene);
  expect_same(one.provenance, other.provenance);
  EXPECT_EQ(one.dimension, other.dimension);
  EXPECT_EQ(one.box_size, other.box_size);
  EXPECT_EQ(one.boundary, other.boundary);
  ASSERT_EQ(one.replicas.size(), other.replicas.size());
  for (std::size_t index = 0; index < one.replicas.size(); ++index) {
    EXPECT_EQ(one.replicas[index].seed, other.replicas[index].seed);
    EXPECT_EQ(one.replicas[index].counters, other.replicas[index].counters);
    expect_same(one.replicas[index].series, other.replicas[index].series);
  }
  ASSERT_EQ(one.estimates.size(), other.estimates.size());
  for (std::size_t index = 0; index < one.estimates.size(); ++index)
    expect_same(one.estimates[index], other.estimates[index]);
  ASSERT_EQ(one.trajectory.size(), other.trajectory.size());
  for (std::size_t index = 0; index < one.trajectory.size(); ++index)
    expect_same(one.trajectory[index], other.trajectory[index]);
  EXPECT_EQ(one.timings, other.timings);
  ASSERT_EQ(one.state.has_value(), other.state.has_value());
  if (one.state) expect_same(*one.state, *other.state);
}

void expect_round_trip(const Record& record, const std::string& path) {
  write_record(path, record);
  expect_same(read_record(path), record);
}

void expect_round_trip(const Record& record) {
  const ScratchFolder folder;
  expect_round_trip(record, folder / "run.h5");
}

TEST(Record, ComesBackBitForBit) { expect_round_trip(sample_record()); }

TEST(Record, ComesBackWhenNearlyEmpty) {
  Record record;
  record.dimension = 3;
  record.box_size = {1, 2, 3};
  record.boundary = {"none", "none", "periodic"};
  expect_round_trip(record);
  record.state.emplace();
  expect_round_trip(record);
  record.replicas.push_back({9, {sample_series({"temperature", "1", "", {}, {}, {}, ""}, 0)}, {}});
  expect_round_trip(record);
}

TEST(Record, HoldsSpinsOfDisksAndSpheres) {
  for (const std::size_t components : {1u, 3u}) {
    Record record = sample_record();
    for (Frame& frame : record.trajectory)
      for (std::size_t i = 0; i < components * frame.id.size(); ++i)
        frame.spin.push_back(0.1 * static_cast<double>(i) - 0.3);
    expect_round_trip(record);
    record.trajectory.back().spin.pop_back();
    const ScratchFolder folder;
    EXPECT_THROW(write_record(folder / "run.h5", record), RunError);
  }
}

TEST(Record, HoldsAxesAndSeriesLargerThanAnAttributeOrAChunk) {
  Record record = sample_record();
  Quantity wide{"wide", "1", "many bins", {20000}, {}, std::vector<double>(20001), "bin"};
  for (std::size_t bin = 0; bin < wide.axis.size(); ++bin) wide.axis[bin] = static_cast<double>(bin);
  for (std::size_t bin = 0; bin < 20000; ++bin) wide.components.push_back("bin " + std::to_string(bin));
  for (Replica& replica : record.replicas) replica.series.push_back(sample_series(wide, 5));
  expect_round_trip(record);
}

TEST(Record, ReplacesTheFormerFile) {
  const ScratchFolder folder;
  Record record = sample_record();
  expect_round_trip(record, folder / "run.h5");
  record.scene = "another";
  record.state.reset();
  expect_round_trip(record, folder / "run.h5");
}

TEST(Record, SurvivesTwoThreads) {
  const auto work = [] {
    for (int round = 0; round < 20; ++round) expect_round_trip(sample_record());
  };
  std::thread other(work);
  work();
  other.join();
}

TEST(Record, WritesAndReadsThroughMpi) {
  const ScratchFolder folder;
  write_record(folder / "without-mpi.h5", sample_record());
  MPI_Init(nullptr, nullptr);
  expect_round_trip(sample_record(), folder / "with-mpi.h5");
  expect_same(read_record(folder / "without-mpi.h5"), sample_record());
  MPI_Finalize();
  expect_same(read_record(folder / "with-mpi.h5"), sample_record());
}

}  // namespace
}  // namespace sandglass

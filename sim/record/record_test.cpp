#include "sim/record/record.hpp"

#include "sim/base/error.hpp"
#include "sim/record/hdf5/file.hpp"
#include "sim/record/hdf5/writer.hpp"
#include "sim/record/sample.hpp"
#include "sim/record/scratch.hpp"

#include <cstring>
#include <limits>
#include <thread>

#include <gtest/gtest.h>
#include <mpi.h>

namespace sandglass::record_test {
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
  ASSERT_EQ(one.columns.all().size(), other.columns.all().size());
  for (const NamedColumn& column : one.columns.all()) {
    const NamedColumn* found = other.columns.find(column.info);
    ASSERT_NE(found, nullptr) << column.info.name;
    EXPECT_EQ(found->info.units, column.info.units);
    std::visit(
        [&]<class T>(const std::vector<T>& values) {
          expect_same_bits(values, std::get<std::vector<T>>(found->numbers));
        },
        column.numbers);
  }
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
  EXPECT_EQ(one.start_time, other.start_time);
  EXPECT_EQ(one.drifts, other.drifts);
}

void expect_same(const Provenance& one, const Provenance& other) {
  EXPECT_EQ(one.program_version, other.program_version);
  EXPECT_EQ(one.commit, other.commit);
  EXPECT_EQ(one.build, other.build);
  EXPECT_EQ(one.created, other.created);
  EXPECT_EQ(one.planted_fault, other.planted_fault);
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
  Record disks = sample_record(), spheres = sample_record();
  for (std::size_t frame = 0; frame < disks.trajectory.size(); ++frame)
    for (std::size_t i = 0; i < disks.trajectory[frame].particles(2); ++i) {
      const double turn = 0.1 * static_cast<double>(i) - 0.3;
      disks.trajectory[frame].columns.append(column::spin<2>, Spin<2>(turn));
      spheres.trajectory[frame].columns.append(column::spin<3>, Spin<3>(turn, 1 / turn, 0));
    }
  expect_round_trip(disks);
  expect_round_trip(spheres);
}

/// Before schema 1.2 columns had no units, before 1.3 estimates were means of the whole run.
TEST(Record, OfSchema11IsRead) {
  const ScratchFolder folder;
  Record record = sample_record();
  for (Frame& frame : record.trajectory)
    for (std::size_t i = 0; i < frame.particles(2); ++i) frame.columns.append(column::spin<2>, Spin<2>(0.5));
  write_record(folder / "run.h5", record);
  {
    const hdf5::Session session;
    const hdf5::Handle file(H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
    for (const char* place : {"particles/all/id", "particles/all/spin"})
      hdf5::require(H5Adelete_by_name(file, place, "units", H5P_DEFAULT));
    for (const char* name : {"start_time", "drifts"})
      hdf5::require(
          H5Ldelete(file, (std::string("sandglass/estimates/momentum/") + name).c_str(), H5P_DEFAULT));
    hdf5::Handle group(H5Gopen2(file, "sandglass", H5P_DEFAULT), H5Gclose);
    hdf5::require(H5Adelete(group, "schema"));
    hdf5::Writer(std::move(group)).attribute("schema", std::vector<int>{1, 1});
  }
  const Record back = read_record(folder / "run.h5");
  EXPECT_EQ(back.trajectory[1].columns.get(column::spin<2>)[4], Spin<2>(0.5));
  EXPECT_EQ(back.trajectory[1].columns.get(column::id)[4], 104u);
  EXPECT_EQ(back.estimates[0].start_time, 0);
  EXPECT_FALSE(back.estimates[0].drifts);
}

/// H5MD readers know from the fill value which places hold no particle.
TEST(Record, NamesTheValueOfPlacesWithoutAParticle) {
  const ScratchFolder folder;
  write_record(folder / "run.h5", sample_record());
  const hdf5::Session session;
  const hdf5::Handle file(H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  const hdf5::Handle ids(H5Dopen2(file, "particles/all/id/value", H5P_DEFAULT), H5Dclose);
  const hdf5::Handle properties(H5Dget_create_plist(ids), H5Pclose);
  std::uint64_t absent = 0, values[3][5];
  hdf5::require(H5Pget_fill_value(properties, H5T_NATIVE_UINT64, &absent));
  EXPECT_EQ(absent, std::numeric_limits<std::uint64_t>::max());
  hdf5::require(H5Dread(ids, H5T_NATIVE_UINT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values));
  EXPECT_EQ(values[0][2], 102u);
  EXPECT_EQ(values[0][3], absent);
}

/// Nobody has declared it but this test.
constexpr ColumnKey<Vector<2>> kMadeUp{"made-up / 100%", "length"};

TEST(Record, HoldsAColumnThatTheRoomDoesNotKnow) {
  Record record = sample_record();
  record.trajectory.push_back({900, 90, {}, {}});  // a frame without particles needs no columns
  for (Frame& frame : record.trajectory)
    for (std::size_t i = 0; i < frame.particles(2); ++i) {
      frame.columns.append(kMadeUp, Vector<2>(0.1 * static_cast<double>(i), -1));
      frame.columns.append(column::species, static_cast<std::uint8_t>(i % 3));
    }
  const ScratchFolder folder;
  write_record(folder / "run.h5", record);
  const Record back = read_record(folder / "run.h5");
  for (std::size_t frame = 0; frame + 1 < record.trajectory.size(); ++frame)
    expect_same(back.trajectory[frame], record.trajectory[frame]);
  EXPECT_EQ(back.trajectory.back().particles(2), 0u);
  EXPECT_EQ(back.trajectory[1].columns.get(kMadeUp)[4], Vector<2>(0.4, -1));
  EXPECT_EQ(back.trajectory[1].columns.get(column::species)[4], 1);
}

TEST(Record, RefusesAColumnThatOnlySomeFramesOrParticlesHave) {
  const ScratchFolder folder;
  Record record = sample_record();
  record.trajectory.back().columns.append(column::id, std::uint64_t{1});
  EXPECT_THROW(write_record(folder / "run.h5", record), RunError);
  record.trajectory.back().columns.remove("id");
  EXPECT_THROW(write_record(folder / "run.h5", record), RunError);
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
}  // namespace sandglass::record_test

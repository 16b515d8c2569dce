#include "sim/record/export.hpp"

#include "sim/base/error.hpp"
#include "sim/record/export/base64.hpp"
#include "sim/record/hdf5/file.hpp"
#include "sim/record/hdf5/reader.hpp"
#include "sim/record/sample.hpp"
#include "sim/record/scratch.hpp"

#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::export_test {
namespace {

using testing::HasSubstr;

std::string contents(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string refusal(const Record& record, const std::string& format, const std::string& path) {
  try {
    export_record(record, format, path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Base64, ExamplesOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Export, XyzHoldsEveryFrameExactly) {
  const ScratchFolder folder;
  const Record record = sample_record();
  export_record(record, "xyz", folder / "run.xyz", {0.5});
  std::ifstream file(folder / "run.xyz");
  for (const Frame& frame : record.trajectory) {
    std::string line;
    std::getline(file, line);
    const std::size_t count = std::stoul(line);
    ASSERT_EQ(count, frame.particles(2));
    std::getline(file, line);
    EXPECT_THAT(line, HasSubstr("Lattice=\"10 0 0 0 20.5 0 0 0 0.5\""));
    EXPECT_THAT(line, HasSubstr("pbc=\"T F F\""));
    for (std::size_t particle = 0; particle < count; ++particle) {
      std::string name;
      double x, y, z, u, v, w, radius;
      std::uint64_t id;
      file >> name >> x >> y >> z >> u >> v >> w >> radius >> id;
      EXPECT_EQ(x, frame.position[2 * particle]);
      EXPECT_EQ(v, frame.velocity[2 * particle + 1]);
      EXPECT_EQ(z + w, 0);
      EXPECT_EQ(radius, 0.25);
      EXPECT_EQ(id, frame.columns.get(column::id)[particle]);
    }
    std::getline(file, line);
  }
}

TEST(Export, VtpWritesOneFilePerFrameAndAList) {
  const ScratchFolder folder;
  const auto paths = export_record(sample_record(), "vtp", folder / "a&b.pvd");
  ASSERT_EQ(paths.size(), 4u);
  EXPECT_EQ(paths.back(), folder / "a&b.pvd");
  EXPECT_THAT(contents(paths.back()), HasSubstr("timestep=\"50\" file=\"a&amp;b-000001.vtp\""));
  const std::string frame = contents(folder / "a&b-000001.vtp");
  EXPECT_THAT(frame, HasSubstr("NumberOfPoints=\"5\" NumberOfVerts=\"5\""));
  // Five diameters of 1: a length of 40 bytes, then 0x3ff0000000000000 five times.
  EXPECT_THAT(frame, HasSubstr("KAAAAAAAAAAAAAAAAADwPwAAAAAAAPA/AAAAAAAA8D8AAAAAAADwPwAAAAAAAPA/"));
}

Record record_with_columns() {
  Record record = sample_record();
  for (Frame& frame : record.trajectory)
    for (std::size_t i = 0; i < frame.particles(2); ++i) {
      frame.columns.append(column::species, static_cast<std::uint8_t>(i % 2));
      frame.columns.append(column::spin<3>, Spin<3>(0.5, -1, 0));
    }
  return record;
}

TEST(Export, XyzAndVtpHoldEveryColumn) {
  const ScratchFolder folder;
  export_record(record_with_columns(), "xyz", folder / "run.xyz");
  EXPECT_THAT(contents(folder / "run.xyz"), HasSubstr(":radius:R:1:id:I:1:species_index:I:1:spin:R:3 "));
  EXPECT_THAT(contents(folder / "run.xyz"), HasSubstr(" 0.5 101 1 0.5 -1 0\n"));
  export_record(record_with_columns(), "vtp", folder / "run.pvd");
  const std::string frame = contents(folder / "run-000000.vtp");
  EXPECT_THAT(frame, HasSubstr("\"UInt64\" Name=\"id\" NumberOfComponents=\"1\""));
  // Three species 0, 1, 0: a length of 3 bytes, then the bytes.
  EXPECT_THAT(frame, HasSubstr("\"UInt8\" Name=\"species\" NumberOfComponents=\"1\" "
                               "format=\"binary\">AwAAAAAAAAAAAQA="));
  EXPECT_THAT(frame, HasSubstr("\"Float64\" Name=\"spin\" NumberOfComponents=\"3\""));
}

/// What species differ in takes the place of what all have alike.
TEST(Export, DiametersOfAMixtureReachEveryFormat) {
  const ScratchFolder folder;
  Record record = record_with_columns();
  for (Frame& frame : record.trajectory)
    for (std::size_t i = 0; i < frame.particles(2); ++i) {
      frame.columns.append(column::diameter, i % 2 == 0 ? 2.0 : 0.5);
      frame.columns.append(column::mass, 3.0);
    }
  export_record(record, "xyz", folder / "run.xyz");
  EXPECT_THAT(contents(folder / "run.xyz"), HasSubstr(":spin:R:3:mass:R:1 "));
  EXPECT_THAT(contents(folder / "run.xyz"),
              HasSubstr("\nHe 2.25 3.25 0 0.2 0.16666666666666666 0 0.25 101 1 "));
  export_record(record, "csv", folder / "run.csv");
  EXPECT_THAT(
      contents(folder / "run-particles.csv"),
      HasSubstr("step,time,position-x,position-y,velocity-x,velocity-y,id,species,spin-x,spin-y,spin-z,"
                "diameter,mass\n300,30,0.25,1.25,0.3333333333333333,0.25,100,0,0.5,-1,0,2,3\n"));
  export_record(record, "vtp", folder / "run.pvd");
  const std::string frame = contents(folder / "run-000000.vtp");
  EXPECT_EQ(frame.find("Name=\"diameter\""), frame.rfind("Name=\"diameter\""));
}

TEST(Export, OfACheckpointShowsItsState) {
  const ScratchFolder folder;
  Record record = sample_record();
  record.trajectory.clear();
  export_record(record, "xyz", folder / "run.xyz");
  EXPECT_THAT(contents(folder / "run.xyz"), HasSubstr("Step=77"));
  export_record(record, "csv", folder / "run.csv");
  EXPECT_THAT(contents(folder / "run.csv"), HasSubstr(",2,20,0.2,"));  // the unfinished replica
  EXPECT_THAT(contents(folder / "run-particles.csv"), HasSubstr("\n77,7.7,"));
}

TEST(Export, ATableOfNothingIsRefused) {
  const ScratchFolder folder;
  Record record = sample_record();
  record.trajectory.clear();
  record.state.reset();
  for (Replica& replica : record.replicas) replica.series.clear();
  EXPECT_THAT(refusal(record, "csv", folder / "run.csv"), HasSubstr("neither series nor particles"));
}

TEST(Export, MdanalysisShowsOtherColumnsAsObservables) {
  const ScratchFolder folder;
  Record record = record_with_columns();
  record.trajectory.resize(1);
  const auto paths = export_record(record, "mdanalysis", folder / "run");
  const hdf5::Session session;
  const hdf5::Handle file = hdf5::open_file(paths.front());
  const hdf5::Reader root(hdf5::Handle(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose), "/");
  EXPECT_EQ(root.group("particles").group("trajectory").names(),
            (std::vector<std::string>{"box", "count", "id", "position", "velocity"}));
  EXPECT_EQ(root.group("observables").names(), (std::vector<std::string>{"species", "spin"}));
  EXPECT_EQ(root.group("observables").group("species").names(),
            (std::vector<std::string>{"step", "time", "value"}));
}

TEST(Export, MdanalysisIsPaddedToThreeDimensions) {
  const ScratchFolder folder;
  Record record = sample_record();
  EXPECT_THAT(refusal(record, "mdanalysis", folder / "run.h5md"), HasSubstr("varies from frame to frame"));
  record.trajectory = {sample_frame(0, 4, 2), sample_frame(10, 4, 2)};
  const auto paths = export_record(record, "mdanalysis", folder / "run", {0.5});
  EXPECT_EQ(paths, std::vector<std::string>{folder / "run.h5md"});

  const hdf5::Session session;
  const hdf5::Handle file = hdf5::open_file(paths.front());
  const hdf5::Reader root(hdf5::Handle(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose), "/");
  const hdf5::Reader trajectory = root.group("particles").group("trajectory");
  const auto edges = trajectory.group("box").group("edges").numbers<double>("value", {2, 3, 3});
  EXPECT_EQ(std::vector<double>(edges.begin(), edges.begin() + 9),
            (std::vector<double>{10, 0, 0, 0, 20.5, 0, 0, 0, 0.5}));
  const auto position = trajectory.group("position").numbers<double>("value", {2, 4, 3});
  EXPECT_EQ(position[3], record.trajectory[0].position[2]);
  EXPECT_EQ(position[5], 0);
}

TEST(Export, CsvHoldsSeriesAndEstimates) {
  const ScratchFolder folder;
  export_record(sample_record(), "csv", folder / "run.csv");
  const std::string series = contents(folder / "run.csv");
  EXPECT_THAT(series, HasSubstr("\nmomentum,y,mass length time^-1,,,0,10,0.1,0.1111111111111111\n"));
  EXPECT_THAT(series, HasSubstr("\nvelocity-histogram,4,1,0,0.5,1,0,0,0.034482758620689655\n"));
  EXPECT_THAT(contents(folder / "run-estimates.csv"),
              HasSubstr("momentum,x,mass length time^-1,,,0.5,0.01,17.5,2.5,yes\n"
                        "momentum,y,mass length time^-1,,,-0.5,,17.5,2.5,yes\n"));
}

TEST(Export, RefusesWhatItCannotDo) {
  const ScratchFolder folder;
  Record record = sample_record();
  EXPECT_THAT(refusal(record, "vtq", folder / "run"), HasSubstr("did you mean 'vtp'"));
  record.trajectory.clear();
  record.state.reset();
  for (const std::string format : {"vtp", "xyz", "mdanalysis"})
    EXPECT_THAT(refusal(record, format, folder / "run"),
                HasSubstr("add 'trajectory = { steps = 100 }' to [output]"));
  EXPECT_NO_THROW(export_record(record, "csv", folder / "run.csv"));
  EXPECT_THROW(export_record(sample_record(), "xyz", folder / "missing/run.xyz"), RunError);
  EXPECT_EQ(export_formats().size(), 4u);
}

}  // namespace
}  // namespace sandglass::export_test

#include "sim/record/output_files.hpp"

#include "sim/base/error.hpp"
#include "sim/record/scratch.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

namespace sandglass::output_files_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void write_file(const std::string& path, const std::string& text = "old") { std::ofstream(path) << text; }

std::string read_file(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What a command is told when it claims `output`; "" when it may write.
std::string refusal_by(OutputFiles& outputs, const OutputFile& output) {
  try {
    outputs.claim(output);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const OutputFile& output, const std::vector<std::string>& inputs = {}) {
  OutputFiles outputs(inputs);
  return refusal_by(outputs, output);
}

TEST(OutputFiles, KeepWhatExistsUnlessAsked) {
  const ScratchFolder folder;
  const std::string path = folder / "gas.h5";
  EXPECT_EQ(refusal({path}), "");
  write_file(path);
  EXPECT_THAT(refusal({path, Existing::keep, "use --overwrite"}),
              HasSubstr("exists already; use --overwrite"));
  EXPECT_EQ(refusal({path, Existing::replace}), "");
  EXPECT_EQ(read_file(path), "old");
  EXPECT_THAT(folder.files(), ElementsAre("gas.h5")) << "claims and probes leave nothing behind";
}

TEST(OutputFiles, AreNoFoldersDevicesInputsOrEachOther) {
  const ScratchFolder folder;
  const std::string scene = folder / "gas.toml", link = folder / "link.toml";
  write_file(scene);
  std::filesystem::create_symlink(scene, link);
  EXPECT_THAT(refusal({folder / "missing/gas.h5", Existing::replace}), HasSubstr("no such folder"));
  EXPECT_THAT(refusal({folder.path(), Existing::replace}), HasSubstr("is a folder"));
  EXPECT_THAT(refusal({"/dev/null", Existing::replace}), HasSubstr("no regular file"));
  for (const std::string& path : {scene, link, folder / "./gas.toml"})
    EXPECT_THAT(refusal({path, Existing::replace}, {scene}), HasSubstr("is what the command reads")) << path;
  OutputFiles outputs({});
  outputs.claim({folder / "new.h5"});
  EXPECT_THAT(refusal_by(outputs, {folder / "./new.h5"}), HasSubstr("written twice"));
}

TEST(OutputFiles, OfOneCommandAreNotThoseOfAnother) {
  const ScratchFolder folder;
  const std::string path = folder / "gas.h5";
  {
    OutputFiles first({});
    first.claim({path});
    EXPECT_THAT(refusal({path}), HasSubstr("another command is writing it"));
    EXPECT_EQ(refusal({folder / "other.h5"}), "");
  }
  EXPECT_EQ(refusal({path}), "");
  write_file(path + ".lock");  // of a command that was killed: nobody holds it
  EXPECT_EQ(refusal({path}), "");
}

TEST(OutputFiles, RemoveWhatKilledCommandsLeftOver) {
  const ScratchFolder folder;
  const std::string path = folder / "gas.h5";
  for (const char* kept : {"gas.h5.part-", "gas.h5.part-7a", "other.h5.part-7"}) write_file(folder / kept);
  write_file(path + ".part-7");
  OutputFiles outputs({});
  EXPECT_THAT(outputs.claim({path}), ElementsAre(path + ".part-7"));
  EXPECT_FALSE(std::filesystem::exists(path + ".part-7"));
  EXPECT_EQ(folder.files().size(), 4u) << "three that are no parts of it, and the lock";
}

TEST(AtomicFile, KeepsWhatAppearedMeanwhile) {
  const ScratchFolder folder;
  const std::string path = folder / "gas.h5";
  for (const std::string& expected : {path, folder / "gas-1.h5", folder / "gas-2.h5"}) {
    AtomicFile file(path);
    file.write(expected);
    EXPECT_EQ(file.commit(Existing::keep), expected);
    EXPECT_EQ(read_file(expected), expected);
  }
  AtomicFile file(path);
  file.write("new");
  EXPECT_EQ(file.commit(), path);
  EXPECT_EQ(read_file(path), "new");
  EXPECT_EQ(folder.files().size(), 3u);
}

TEST(AtomicFile, LeavesDevicesAlone) {
  EXPECT_THROW(AtomicFile("/dev/null"), RunError);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace sandglass::output_files_test

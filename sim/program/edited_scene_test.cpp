#include "sim/program/edited_scene.hpp"

#include "sim/base/error.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::program::edited_scene_test {
namespace {

using ::testing::HasSubstr;

constexpr const char* kScene = R"(
run = { seed = 1, duration = { steps = 50 } }
domain = { dimension = 2, size = [40.0, 40.0] }
method = { preset = "cba", cell-size = 5.0, weight = 0.1, time-step = 0.4 }
[[species]]
area-fraction = 0.05
restitution = 0.9
)";

class EditedScene : public ::testing::Test {
 protected:
  /// Tests run beside each other: each has a file of its own.
  EditedScene()
      : path_(std::filesystem::temp_directory_path() /
              (std::string("sandglass_") + testing::UnitTest::GetInstance()->current_test_info()->name() +
               ".toml")) {
    std::ofstream(path_) << kScene;
  }
  ~EditedScene() override { std::filesystem::remove(path_); }

  Scene read(const std::vector<std::string>& settings) const {
    return read_edited_scene(path_.string(), settings);
  }
  std::string refusal(const std::string& setting) const {
    try {
      read({setting});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path path_;
};

TEST_F(EditedScene, WithoutSettingsIsTheFile) { EXPECT_EQ(read({}).species.front().restitution, 0.9); }

TEST_F(EditedScene, TakesNumbersWordsAndTables) {
  const Scene scene = read({"species.restitution=0.5", "method.preset=dsmc", "title='two words'",
                            "run.duration={}", "run.duration={time = 3.0}", "species.restitution = 0.25"});
  EXPECT_EQ(scene.species.front().restitution, 0.25);
  EXPECT_EQ(scene.title, "two words");
  EXPECT_EQ(scene.run.duration.time, 3.0);
  EXPECT_THAT(write_scene(scene), HasSubstr("dsmc"));
}

TEST_F(EditedScene, ErrorsNameTheSetting) {
  EXPECT_THAT(refusal("species.restitution=1.5"), HasSubstr("--set species.restitution=1.5"));
  EXPECT_THAT(refusal("species.restituton=0.5"), HasSubstr("did you mean 'restitution'"));
  EXPECT_THAT(refusal("species.restitution"), HasSubstr("write key=value"));
  EXPECT_THAT(refusal("run.seed=[1"), HasSubstr("--set run.seed=[1"));
}

}  // namespace
}  // namespace sandglass::program::edited_scene_test

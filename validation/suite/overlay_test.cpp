#include "validation/suite/overlay.hpp"

#include "validation/suite/matrix.hpp"

#include <gtest/gtest.h>

namespace sandglass::overlay_test {
namespace {

constexpr const char* base_text =
    "title = \"base \\\"quoted\\\"\"\nrun = { seed = 3, duration.steps = 10 }\n[domain]\ndimension = 2\nsize "
    "= [10.0, 20.0]\n"
    "[[species]]\ncount = 20\nrestitution = 0.9\n[method]\ncells = [2, 4]\ntime-step = 0.1\n";

Scene laid_over(const std::vector<std::string>& texts) {
  std::vector<Override> overrides;
  for (const std::string& text : texts) overrides.push_back({parse_document(text, "over.toml"), "over.toml"});
  std::vector<const Override*> pointers;
  for (const Override& layer : overrides) pointers.push_back(&layer);
  return lay_over(parse_document(base_text, "base.toml"), "base.toml", pointers);
}

TEST(Overlay, NothingOnTopIsTheBase) {
  const Scene scene = laid_over({});
  EXPECT_EQ(scene.title, "base \"quoted\"");
  EXPECT_EQ(scene.run.duration.steps, 10U);
  EXPECT_EQ(write_scene(scene), write_scene(read_scene_text(base_text, "base.toml")));
}

TEST(Overlay, TablesMergeAndTheLastOneWins) {
  const Scene scene = laid_over({"method.preset = \"cba\"\nrun.seed = 5", "run.seed = 7"});
  EXPECT_EQ(scene.method.preset, "cba");
  EXPECT_EQ(scene.method.time_step.fixed, 0.1);
  EXPECT_EQ(scene.run.seed, 7U);
}

TEST(Overlay, TableOverSpeciesGoesIntoTheFirst) {
  const Scene scene = laid_over({"species.restitution = 0.5"});
  EXPECT_EQ(scene.species.at(0).restitution, 0.5);
  EXPECT_EQ(scene.species.at(0).count, 20U);
}

TEST(Overlay, EmptyTableRemoves) {
  const Scene scene = laid_over({"species = { count = {}, area-fraction = 0.1 }\nmethod.time-step = {}",
                                 "method.time-step = { collisions-per-particle = 0.2 }"});
  EXPECT_FALSE(scene.species.at(0).count.has_value());
  EXPECT_EQ(scene.method.time_step.collisions, 0.2);
}

TEST(Overlay, ListsOfTablesAreReplaced) {
  const Scene scene = laid_over({"observe = [{ what = \"energy\", every.steps = 2 }]"});
  ASSERT_EQ(scene.observe.size(), 1U);
  EXPECT_EQ(scene.observe[0].cadence.every, 2);
}

TEST(DerivedSeed, DiffersByNameAndSeedAndFitsToml) {
  EXPECT_NE(derived_seed(1, "a"), derived_seed(1, "b"));
  EXPECT_NE(derived_seed(1, "a"), derived_seed(2, "a"));
  EXPECT_EQ(derived_seed(1, "a"), derived_seed(1, "a"));
  for (int i = 0; i < 100; ++i)
    EXPECT_LT(derived_seed(static_cast<std::uint64_t>(i), "x"), std::uint64_t{1} << 63);
}

}  // namespace
}  // namespace sandglass::overlay_test

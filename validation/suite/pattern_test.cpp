#include "validation/suite/pattern.hpp"

#include <gtest/gtest.h>

namespace sandglass::pattern_test {
namespace {

using Names = std::vector<std::string>;

const std::vector<Choice> points{
    {"dilute-r-0.9", {}}, {"nu-0.05-r-0.9", {"dense"}}, {"nu-0.05-r-0.5", {"dense"}}};

TEST(Pattern, StarAndQuestionMark) {
  EXPECT_TRUE(matches("nu-*-r-0.9", "nu-0.05-r-0.9"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("a*b*c", "aXbbYc"));
  EXPECT_TRUE(matches("r-0.?", "r-0.9"));
  EXPECT_FALSE(matches("r-0.?", "r-0."));
  EXPECT_FALSE(matches("nu-*", "dilute-nu-"));
  EXPECT_FALSE(matches("nu.", "nu-")) << "a dot is a dot";
}

TEST(Pattern, ChoosesByNameAndTag) {
  EXPECT_EQ(choose({"dense"}, points), (Names{"nu-0.05-r-0.9", "nu-0.05-r-0.5"}));
  EXPECT_EQ(choose({"*-r-0.9"}, points), (Names{"dilute-r-0.9", "nu-0.05-r-0.9"}));
}

TEST(Pattern, NoPatternChoosesAll) { EXPECT_EQ(choose({}, points).size(), 3U); }

TEST(Pattern, ExclamationMarkTakesAway) {
  EXPECT_EQ(choose({"!dense"}, points), Names{"dilute-r-0.9"});
  EXPECT_EQ(choose({"dense", "!*-0.5"}, points), Names{"nu-0.05-r-0.9"});
}

TEST(Pattern, WordsAreNamesAndTagsOnce) {
  EXPECT_EQ(words_of(points), (Names{"dilute-r-0.9", "nu-0.05-r-0.9", "nu-0.05-r-0.5", "dense"}));
}

}  // namespace
}  // namespace sandglass::pattern_test

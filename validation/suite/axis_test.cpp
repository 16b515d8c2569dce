#include "validation/suite/axis.hpp"

#include "sim/base/error.hpp"
#include "validation/suite/read_parts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::axis_test {
namespace {

using testing::HasSubstr;

const std::string axes = R"(
[[axis]]
nu = [0.05, 0.25]
cells = [[5, 5], [3, 3]]
[[axis]]
r = [1.0, 0.9, 0.5]
runs = [4, 20, 40]
)";

std::vector<Node> points_of(const std::string& text) {
  const Node document = parse_document(text, "case.toml");
  Diagnostics diagnostics("case.toml", document);
  const Node result = multiply_points(document, diagnostics);
  diagnostics.raise();
  EXPECT_EQ(entry_of(result, "axis"), nullptr);
  return entry_of(result, "point")->items;
}

std::vector<std::string> names_of(const std::vector<Node>& points) {
  std::vector<std::string> names;
  for (const Node& point : points) names.push_back(entry_of(point, "name")->text);
  return names;
}

std::string error_of(const std::string& text) {
  try {
    points_of(text);
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 1U)
        << "a template makes one mistake, however many points it stands for";
    return error.diagnostics().front().text();
  }
  return "";
}

TEST(Axis, NameMultipliesTheAxesThatItHolds) {
  EXPECT_THAT(names_of(points_of(axes + "[[point]]\nname = \"nu-{nu}-r-{r}\"\n")),
              testing::ElementsAre("nu-0.05-r-1", "nu-0.05-r-0.9", "nu-0.05-r-0.5", "nu-0.25-r-1",
                                   "nu-0.25-r-0.9", "nu-0.25-r-0.5"));
  EXPECT_THAT(names_of(points_of(axes + "[[point]]\nname = \"alone\"\n[[point]]\nname = \"r-{r}\"\n")),
              testing::ElementsAre("alone", "r-1", "r-0.9", "r-0.5"));
}

TEST(Axis, ColumnAloneIsTheValueAndBesideTextItsText) {
  const Node point =
      points_of(axes +
                "[[point]]\nname = \"r-{r}\"\nsummary = \"{runs} runs at {r}\"\nset.run.replicas = "
                "\"{runs}\"\n")
          .at(1);
  EXPECT_EQ(entry_of(point, "summary")->text, "20 runs at 0.9");
  const Node& replicas = *entry_of(*entry_of(*entry_of(point, "set"), "run"), "replicas");
  EXPECT_EQ(replicas.kind, Node::Kind::whole);
  EXPECT_EQ(replicas.whole, 20);
  EXPECT_EQ(replicas.key, "replicas");
}

TEST(Axis, ColumnMayHoldLists) {
  const Node point = points_of(axes + "[[point]]\nname = \"{nu}\"\nset.cells = \"{cells}\"\n").at(1);
  EXPECT_EQ(entry_of(*entry_of(point, "set"), "cells")->items.at(1).whole, 3);
}

TEST(Axis, ExceptLeavesOut) {
  EXPECT_THAT(names_of(points_of(axes + "[[point]]\nname = \"r-{r}\"\nexcept = [\"r-1\", \"*.5\"]\n")),
              testing::ElementsAre("r-0.9"));
}

TEST(Axis, ErrorsHaveTheirPlaceAndTheNearestSpelling) {
  EXPECT_THAT(error_of(axes + "[[point]]\nname = \"r-{rr}\"\n"),
              testing::AllOf(HasSubstr("case.toml:9:8"), HasSubstr("did you mean 'r'"), HasSubstr("'runs'")));
  EXPECT_THAT(error_of(axes + "[[point]]\nname = \"r-{r}\"\nsummary = \"{nu}\"\n"),
              HasSubstr("'{nu}' has no value here"));
  EXPECT_THAT(error_of("[[axis]]\na = [1, 2]\nb = [1]\n[[point]]\nname = \"{a}\"\n"),
              testing::AllOf(HasSubstr("case.toml:3"), HasSubstr("as long as the other columns")));
  EXPECT_THAT(error_of("[[axis]]\na = [1]\n[[axis]]\na = [1]\n[[point]]\nname = \"{a}\"\n"),
              HasSubstr("rename one"));
  EXPECT_THAT(error_of(axes + "[[point]]\nname = \"r-{r}\"\nexcept = \"q\"\n"),
              HasSubstr("matches the name of no point"));
}

}  // namespace
}  // namespace sandglass::axis_test

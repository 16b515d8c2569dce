#include "sim/base/error.hpp"
#include "validation/law/example.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::law::registry_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string refusal(const std::string& name, const Arguments& arguments) {
  return message_of([&] { evaluate(find_law(name), arguments); });
}

const Arguments kExample = {{"restitution", 0.9}, {"diameter", 1},         {"mass", 1},
                            {"temperature", 1},   {"area-fraction", 0.25}, {"dimension", 2}};

Arguments example_with(const std::string& name, double value) {
  Arguments arguments = kExample;
  arguments[name] = value;
  return arguments;
}

/// Small letters and digits in words joined by single hyphens, starting with a letter.
bool well_spelled(const std::string& name) {
  constexpr const char* letters = "abcdefghijklmnopqrstuvwxyz0123456789-";
  return name.find_first_not_of(letters) == std::string::npos && name.front() >= 'a' && name.back() != '-' &&
         name.find("--") == std::string::npos;
}

std::string theory_page() {
  std::ifstream file(std::string(SANDGLASS_SOURCE_DIR) + "/docs/theory.md");
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Registry, NamesAreUniqueAndEveryFieldIsFilled) {
  std::set<std::string> names;
  for (const Law& law : all_laws()) {
    EXPECT_TRUE(names.insert(law.name).second) << law.name;
    EXPECT_TRUE(well_spelled(law.name)) << law.name;
    for (const std::string& field : {law.summary, law.source, law.units, law.validity})
      EXPECT_FALSE(field.empty()) << law.name;
    for (const Parameter& parameter : law.parameters) {
      EXPECT_TRUE(well_spelled(parameter.name)) << law.name;
      EXPECT_LT(parameter.low, parameter.high) << law.name << " " << parameter.name;
      EXPECT_FALSE(parameter.units.empty() || parameter.summary.empty()) << law.name << " " << parameter.name;
    }
  }
  EXPECT_GT(names.size(), 30u);
}

TEST(Registry, EveryLawHasAValueInTwoAndThreeDimensions) {
  for (const Law& law : all_laws())
    for (int dimension : {2, 3}) {
      const Arguments arguments = example_arguments(law, dimension);
      EXPECT_EQ(message_of([&] { evaluate(law, arguments); }), "no error") << law.name;
    }
}

TEST(Registry, EveryLawStandsOnTheTheoryPage) {
  const std::string page = theory_page();
  for (const Law& law : all_laws()) EXPECT_NE(page.find("`" + law.name + "`"), std::string::npos) << law.name;
}

TEST(Evaluate, GivesHaffsTimeScale) {
  const double contact = (1 - 7 * 0.25 / 16) / (0.75 * 0.75);
  const double expected = std::sqrt(std::numbers::pi) / contact / (2 * 0.19 * 0.25);
  EXPECT_NEAR(evaluate(find_law("haff-time-scale"), kExample), expected, 1e-12);
}

TEST(Evaluate, TakesTheFractionOfItsDimension) {
  EXPECT_NEAR(evaluate(find_law("contact-value"), {{"volume-fraction", 0.2}, {"dimension", 3}}),
              0.9 / (0.8 * 0.8 * 0.8), 1e-14);
  Arguments wrong = kExample;
  wrong["dimension"] = 3;
  EXPECT_THAT(refusal("haff-time-scale", wrong), AllOf(HasSubstr("'area-fraction' belongs to dimension=2"),
                                                       HasSubstr("needs 'volume-fraction'")));
}

TEST(Evaluate, FillsInFallbacks) {
  EXPECT_DOUBLE_EQ(evaluate(find_law("mean-speed"), {{"dimension", 2}}), std::sqrt(std::numbers::pi / 2));
}

TEST(Evaluate, RefusesWhatIsOutOfRange) {
  EXPECT_THAT(refusal("haff-time-scale", example_with("dimension", 2.5)),
              HasSubstr("dimension=2.5 is out of range; allowed: 2 or 3"));
  EXPECT_THAT(refusal("haff-time-scale", example_with("restitution", 1.2)),
              HasSubstr("restitution=1.2 is out of range; allowed: 0 to 1"));
  EXPECT_THAT(refusal("haff-time-scale", example_with("area-fraction", 0.95)), HasSubstr("0 to 0.9068"));
  EXPECT_THAT(refusal("haff-time-scale", example_with("diameter", -1)), HasSubstr("a positive number"));
  EXPECT_THAT(refusal("haff-time-scale", example_with("mass", std::nan(""))), HasSubstr("mass=nan"));
  EXPECT_THAT(refusal("haff-time-scale", example_with("mass", std::numeric_limits<double>::infinity())),
              HasSubstr("mass=inf"));
  EXPECT_THAT(refusal("sonine-speed-moment", {{"order", 3}, {"sonine-a2", 0}, {"dimension", 2}}),
              HasSubstr("order=3 is out of range; allowed: 0 to 8 in steps of 2"));
}

TEST(Evaluate, NamesTheNearestSpelling) {
  EXPECT_THAT(message_of([] { find_law("haff-timescale"); }), HasSubstr("did you mean 'haff-time-scale'?"));
  EXPECT_THAT(refusal("haff-time-scale", example_with("resitution", 0.9)),
              HasSubstr("did you mean 'restitution'?"));
}

TEST(Evaluate, ReportsEveryFaultAtOnce) {
  EXPECT_THAT(refusal("haff-time-scale", {{"resitution", 0.9}, {"mass", -1}}),
              AllOf(HasSubstr("'resitution'"), HasSubstr("needs 'restitution'"), HasSubstr("mass=-1"),
                    HasSubstr("needs 'dimension'"), Not(HasSubstr("area-fraction="))));
}

TEST(Evaluate, LetsNoInfinityOut) {
  EXPECT_THAT(
      refusal("haff-time-scale", example_with("restitution", 1)),
      AllOf(HasSubstr("no finite value"), HasSubstr("restitution=1"), HasSubstr("restitution below 1")));
  EXPECT_THAT(refusal("haff-time-scale", example_with("area-fraction", 0)), HasSubstr("fraction above 0"));
}

}  // namespace
}  // namespace sandglass::law::registry_test

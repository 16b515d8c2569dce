#include "sim/base/error.hpp"
#include "validation/suite/mutants.hpp"
#include "validation/suite/synthetic_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::variants_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* library = R"(
[[variant]]
name = "dsmc"
tags = ["monte-carlo", "gas"]
set.method.preset = "dsmc"
[[variant]]
name = "cba"
tags = ["monte-carlo", "gas", "displaced"]
set.method.preset = "cba"
[[variant]]
name = "event-driven"
tags = ["gas", "contacts"]
set = { method = { preset = "event-driven", cells = {} }, initial.positions = "lattice" }
add = [{ checks = "overlap", observe = [{ what = "overlap" }] }]
[[known-limit]]
variants = "dsmc"
checks = "*-conservation"
points = "dense"
reason = "of the method"
)";

/// A case over the library.
Case with_library(const std::string& text, const std::string& variants = library) {
  const SyntheticCase files;
  files.write_variants(variants);
  files.write_case(text);
  return read_case(files.folder().string());
}

std::string error_of(const std::string& text, const std::string& variants = library) {
  try {
    with_library(text, variants);
  } catch (const InputError& error) {
    std::string all;
    for (const Diagnostic& diagnostic : error.diagnostics()) all += diagnostic.text() + "\n";
    return all;
  }
  return "";
}

std::vector<std::string> variants_of(const Case& subject) {
  std::vector<std::string> names;
  for (const Variant& variant : subject.variants) names.push_back(variant.name);
  return names;
}

const std::string points = "[[point]]\nname = \"thin\"\n[[point]]\nname = \"thick\"\ntags = \"dense\"\n";
const std::string check = "[[check]]\ncheck = \"energy-conservation\"\n";

TEST(Variants, AreChosenByNameTagAndNeed) {
  EXPECT_THAT(variants_of(with_library("variants = \"cba\"\n" + points + check)), ElementsAre("cba"));
  EXPECT_THAT(variants_of(with_library("variants = [\"monte-carlo\", \"!dsmc\"]\n" + points + check)),
              ElementsAre("cba"));
  EXPECT_THAT(variants_of(with_library("needs = [\"gas\", \"displaced\"]\n" + points + check)),
              ElementsAre("cba"));
  EXPECT_THAT(variants_of(with_library("needs = \"gas\"\n" + points + check)),
              ElementsAre("dsmc", "cba", "event-driven"));
}

TEST(Variants, OneMoreEntryRunsInEveryCaseThatNeedsItsTags) {
  const std::string more =
      std::string(library) + "[[variant]]\nname = \"new\"\ntags = \"gas\"\nset.run.seed = 8\n";
  EXPECT_THAT(variants_of(with_library("needs = \"gas\"\n" + points + check, more)),
              testing::Contains("new"));
}

TEST(Variants, CaseChangesASharedOneAndAddsItsOwn) {
  const Case subject =
      with_library("variants = \"dsmc\"\n" + points +
                   "[[variant]]\nvariants = \"monte-carlo\"\npoints = \"dense\"\nset.run.seed = 9\n"
                   "[[variant]]\nname = \"own\"\nset.run.seed = 10\n" +
                   check);
  EXPECT_THAT(variants_of(subject), ElementsAre("dsmc", "own"));
  EXPECT_FALSE(subject.runs("thin", "dsmc"));
  EXPECT_EQ(scene_of(subject, "standard", "dsmc", "thick", {}).run.seed, 9U);
  EXPECT_EQ(scene_of(subject, "standard", "own", "thin", {}).run.seed, 10U);
}

TEST(Variants, ObserveWhatTheChecksOfTheCaseNeed) {
  const auto observers = [&](const std::string& more) {
    const Case subject = with_library("variants = \"event-driven\"\n" + points + check + more);
    return scene_of(subject, "standard", "event-driven", "thin", {}).observe;
  };
  EXPECT_EQ(observers("").size(), 2U);
  const std::vector<Observe> with = observers("[[check]]\ncheck = \"overlap\"\n");
  ASSERT_EQ(with.size(), 3U);
  EXPECT_EQ(with.back().what, "overlap");
  EXPECT_EQ(with.back().cadence.every, 1) << "as the last of the scene";
}

TEST(Variants, AddedObserverGivesWayToTheSceneS) {
  const Case subject = with_library(
      "variants = \"event-driven\"\n" + points +
      "[[variant]]\nvariants = \"contacts\"\nset.observe = [{ what = \"overlap\", every.steps = 7 "
      "}]\n[[check]]\ncheck = \"overlap\"\n");
  const std::vector<Observe> observe = scene_of(subject, "standard", "event-driven", "thin", {}).observe;
  ASSERT_EQ(observe.size(), 1U);
  EXPECT_EQ(observe.front().cadence.every, 7);
}

TEST(KnownLimits, BelongToTheVariantWhereTheTagSays) {
  const Case subject = with_library("needs = \"monte-carlo\"\n" + points + check);
  const CheckUse& use = subject.checks.at(0);
  ASSERT_NE(use.known_limit("thick", "dsmc"), nullptr);
  EXPECT_EQ(use.known_limit("thick", "dsmc")->reason, "of the method");
  EXPECT_EQ(use.known_limit("thin", "dsmc"), nullptr);
  EXPECT_EQ(use.known_limit("thick", "cba"), nullptr);
}

TEST(KnownLimits, CaseLiftsOneAndAddsAnother) {
  const Case subject = with_library("needs = \"monte-carlo\"\n" + points + check +
                                    "[[check.lifted-limit]]\npoints = \"thick\"\nreason = \"seen\"\n"
                                    "[[check.known-limit]]\nvariants = \"cba\"\nreason = \"of the case\"\n");
  EXPECT_EQ(subject.checks.at(0).known_limit("thick", "dsmc"), nullptr);
  EXPECT_EQ(subject.checks.at(0).known_limit("thin", "cba")->reason, "of the case");
}

TEST(KnownLimits, SayWithNumbersOfTheCheckWhatIsSeenInstead) {
  const std::string head = "variants = \"dsmc\"\n" + points + "[[check]]\ncheck = \"haff-cooling\"\n";
  const std::string limit = "[[check.known-limit]]\nreason = \"of the case\"\ninstead = { contact-valu";
  const Case subject = with_library(head + limit + "e = 1.0 }\n");
  EXPECT_EQ(subject.checks.at(0).known_limit("thin", "dsmc")->instead.at("contact-value"), 1);
  EXPECT_THAT(error_of(head + limit + " = 1.0 }\n"), HasSubstr("did you mean 'contact-value'"));
}

TEST(CheckAt, TakesWhatItDoesNotSayFromItsCheck) {
  const Case subject =
      with_library("variants = \"dsmc\"\n" + points +
                   "[[check]]\ncheck = [\"energy-conservation\", \"momentum-conservation\"]\nresolution = "
                   "0.5\nat = [{ points = \"dense\", systematic = 0.1 }, { points = \"thin\", resolution = "
                   "0.2 }]\n");
  const CheckUse& thick = *subject.use_of("momentum-conservation", "thick", "dsmc");
  EXPECT_EQ(thick.settings.systematic, 0.1);
  EXPECT_EQ(thick.settings.resolution, 0.5);
  EXPECT_EQ(subject.use_of("energy-conservation", "thin", "dsmc")->settings.resolution, 0.2);
}

TEST(Selections, ErrorsNameWhatCouldHaveBeenMeant) {
  const std::string head = "variants = \"dsmc\"\n" + points;
  EXPECT_THAT(error_of("variants = \"monte-crlo\"\n" + points + check),
              HasSubstr("did you mean 'monte-carlo'"));
  EXPECT_THAT(error_of("needs = \"gass\"\n" + points + check), HasSubstr("did you mean 'gas'"));
  EXPECT_THAT(error_of(head + check + "points = \"thn\"\n"), HasSubstr("did you mean 'thin'"));
  EXPECT_THAT(error_of(head + check + "points = \"x*\"\n"), HasSubstr("unknown point 'x*'"));
  EXPECT_THAT(error_of(head + check + "points = [\"!thin\", \"!dense\"]\n"),
              HasSubstr("takes away every point"));
  EXPECT_THAT(error_of(head + check + check), HasSubstr("is made twice at point 'thin' of variant 'dsmc'"));
  EXPECT_THAT(error_of("variants = \"dsmc\"\n[[point]]\nname = \"dense\"\n" + points + check),
              HasSubstr("'dense' is the name of a point and a tag"));
  EXPECT_THAT(error_of(points + check), HasSubstr("a case needs at least one [[variant]]"));
}

TEST(Selections, ErrorsOfTheLibraryArePlacedThere) {
  EXPECT_THAT(error_of("variants = \"dsmc\"\n" + points + check,
                       "[[variant]]\nname = \"dsmc\"\n[[known-limit]]\nvariants = \"dsc\"\nchecks = "
                       "\"x\"\nreason = \"r\"\n"),
              testing::AllOf(HasSubstr("variants.toml:4"), HasSubstr("did you mean 'dsmc'"),
                             HasSubstr("unknown check 'x'")));
}

const std::string fault =
    "[[mutant]]\nmutation = \"restitution-minus-2-percent\"\ncheck = \"energy-conservation\"\n";

TEST(Mutants, SpreadOverWhatTheirPatternsChoose) {
  const Case subject =
      with_library("needs = \"monte-carlo\"\n" + points + check + fault +
                   "points = \"thin\"\nat = [{ variants = \"cba\" }, { variants = \"dsmc\", set.run.replicas "
                   "= 3 }]\n");
  ASSERT_EQ(subject.mutants.size(), 2U);
  EXPECT_EQ(subject.mutants[0].variant, "cba");
  EXPECT_EQ(mutant_task(subject, "smoke", subject.mutants[1]).scene.run.replicas, 3U);
}

TEST(Mutants, NeedACheckAndAnHonestRunThatPasses) {
  const std::string head = "needs = \"monte-carlo\"\n" + points + check;
  EXPECT_THAT(error_of(head + fault + "points = \"thick\"\nvariants = \"dsmc\"\n"),
              HasSubstr("is a known limit"));
  EXPECT_THAT(
      error_of(head +
               "[[mutant]]\nmutation = \"momentum-leak\"\ncheck = \"overlap\"\npoints = \"*\"\nvariants = "
               "\"*\"\n"),
      HasSubstr("does not make the check 'overlap' there"));
  EXPECT_THAT(error_of(head + fault),
              testing::AllOf(HasSubstr("missing 'mutant.points'"), HasSubstr("mutant.variants")));
}

TEST(Mutants, EachFamilyNeedsItsOwn) {
  const std::string head = "variants = [\"cba\", \"event-driven\"]\n" + points + check;
  const Case half = with_library(head + fault + "variants = \"cba\"\npoints = \"thin\"\n");
  ASSERT_EQ(untested_checks(half).size(), 1U);
  EXPECT_EQ(untested_checks(half)[0].check, "energy-conservation");
  EXPECT_EQ(untested_checks(half)[0].family, "event-driven");
  EXPECT_TRUE(untested_checks(with_library(head + fault + "variants = \"*\"\npoints = \"thin\"\n")).empty());
}

TEST(Mutants, CheckThatMustFailNeedsNone) {
  const Case subject =
      with_library("variants = \"dsmc\"\n[[point]]\nname = \"thick\"\ntags = \"dense\"\n" + check);
  EXPECT_TRUE(untested_checks(subject).empty());
}

}  // namespace
}  // namespace sandglass::variants_test

#include "sim/base/error.hpp"
#include "validation/suite/mutants.hpp"
#include "validation/suite/read_parts.hpp"
#include "validation/suite/synthetic_case.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::read_case_test {
namespace {

using testing::HasSubstr;

std::string errors_of(const SyntheticCase& files) {
  try {
    for (const std::string& tier : tier_names()) expand(read_case(files.folder().string()), tier, "");
  } catch (const InputError& error) {
    std::string text;
    for (const Diagnostic& diagnostic : error.diagnostics()) text += diagnostic.text() + "\n";
    return text;
  }
  return "";
}

TEST(ReadCase, ReadsWhatStandsThere) {
  const SyntheticCase files(
      "numbers = {}\nresolution = 0.5\n[[tier]]\nname = \"smoke\"\n[[tier.change]]\nset.run.seed = 9\n");
  const Case subject = read_case(files.folder().string());
  EXPECT_EQ(subject.name, "small");
  EXPECT_EQ(subject.checks.at(0).settings.resolution, 0.5);
  EXPECT_EQ(expand(subject, "standard", "").at(0).scene.run.seed, 3U);
  EXPECT_EQ(expand(subject, "smoke", "").at(0).scene.run.seed, 9U);
}

TEST(ReadCase, UnknownKeyHasItsPlaceAndTheNearestSpelling) {
  EXPECT_THAT(errors_of(SyntheticCase("resolutoin = 0.5\n")),
              testing::AllOf(HasSubstr("case.toml:12:1"), HasSubstr("did you mean 'resolution'")));
}

TEST(ReadCase, NamesThatNameNothingAreRefusedAllAtOnce) {
  const std::string errors =
      errors_of(SyntheticCase("points = [\"on\"]\n[[mutant]]\nmutation = \"bound-halvd\"\ncheck = "
                              "\"energy-conservation\"\nvariants = \"dsmc\"\n"
                              "points = \"one\"\n"));
  EXPECT_THAT(errors, HasSubstr("unknown point 'on'"));
  EXPECT_THAT(errors, HasSubstr("did you mean 'bound-halved'"));
}

TEST(ReadCase, UnknownCheckNumberIsRefused) {
  EXPECT_THAT(errors_of(SyntheticCase("numbers = { settle = 3 }\n")), HasSubstr("'settle'"));
}

TEST(ReadCase, MisspeltOverrideIsPlacedWhereItStands) {
  const std::string errors = errors_of(SyntheticCase("", "set.species.restituton = 0.9"));
  EXPECT_THAT(errors, testing::AllOf(HasSubstr("case.toml:7:"), HasSubstr("did you mean 'restitution'")));
}

TEST(ReadCase, OverrideOutOfRangeIsPlacedWhereItStands) {
  EXPECT_THAT(errors_of(SyntheticCase("", "set.species = { restitution = 1.2 }")), HasSubstr("case.toml:7:"));
}

TEST(ReadCase, EveryCommittedCaseCanRunInEveryTier) {
  const std::vector<Case> cases = read_cases(SANDGLASS_SOURCE_DIR "/validation/case");
  EXPECT_GE(cases.size(), 4U);
  for (const Case& subject : cases)
    for (const std::string& tier : tier_names())
      EXPECT_FALSE(expand(subject, tier, "").empty()) << subject.name;
}

TEST(ReadCase, EveryCheckHasAMutantInEachFamily) {
  for (const Case& subject : read_cases(SANDGLASS_SOURCE_DIR "/validation/case"))
    for (const UntestedCheck& untested : untested_checks(subject))
      ADD_FAILURE() << subject.name << " plants no fault for " << untested.check << " in " << untested.family;
}

TEST(ReadCase, EveryCheckIsUsedByACase) {
  std::set<std::string> used;
  for (const Case& subject : read_cases(SANDGLASS_SOURCE_DIR "/validation/case"))
    for (const CheckUse& use : subject.checks) used.insert(use.check);
  for (const CheckInfo& check : all_checks()) EXPECT_TRUE(used.contains(check.name)) << check.name;
}

/// A pattern of the shared file may match nothing in one case, but not in all of them.
TEST(ReadCase, EverySharedLimitAndAdditionIsUsedByACase) {
  const std::string folder = SANDGLASS_SOURCE_DIR "/validation/case";
  const std::vector<Case> cases = read_cases(folder);
  const VariantLibrary library = read_variant_library(folder + "/variants.toml");
  std::set<std::string> reasons, added;
  for (const Case& subject : cases) {
    for (const CheckUse& use : subject.checks)
      for (const KnownLimit& limit : use.limits) reasons.insert(limit.reason);
    for (const Variant& variant : subject.variants)
      if (!variant.added.empty()) added.insert(variant.name);
  }
  for (const SharedLimit& limit : library.limits) EXPECT_TRUE(reasons.contains(limit.reason)) << limit.reason;
  for (const SharedVariant& shared : library.variants)
    EXPECT_TRUE(shared.additions.empty() || added.contains(shared.variant.name)) << shared.variant.name;
}

}  // namespace
}  // namespace sandglass::read_case_test

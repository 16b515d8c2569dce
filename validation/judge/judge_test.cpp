#include "validation/judge/judge.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace sandglass::judge_test {
namespace {

constexpr double two_sigma = 0.0455002638963584;  // probability beyond two standard errors, either side

Evidence evidence(double value, double standard_error, double expected) {
  Evidence result;
  result.value = value;
  result.standard_error = standard_error;
  result.expected = expected;
  return result;
}

Verdict verdict(const Evidence& found, bool known_limit = false) {
  return judge(found, Confidence{two_sigma}, known_limit).verdict;
}

TEST(Judge, BudgetIsSystematicPlusErrorsInQuadrature) {
  Evidence found = evidence(1, 0.3, 1);
  found.budget.reference = 0.4;
  found.budget.systematic = 0.25;
  EXPECT_NEAR(judge(found, Confidence{two_sigma}, false).budget, 1.25, 1e-9);
}

TEST(Judge, InsidePassesOutsideFails) {
  EXPECT_EQ(verdict(evidence(1.19, 0.1, 1)), Verdict::pass);
  EXPECT_EQ(verdict(evidence(0.79, 0.1, 1)), Verdict::fail);
}

TEST(Judge, ExactComparisonNeedsNoError) {
  EXPECT_EQ(verdict(evidence(1, 0, 1)), Verdict::pass);
  EXPECT_EQ(verdict(evidence(1.0000001, 0, 1)), Verdict::fail);
}

TEST(Judge, KnownLimitMustFail) {
  EXPECT_EQ(verdict(evidence(2, 0.1, 1), true), Verdict::expected_fail);
  EXPECT_EQ(verdict(evidence(1, 0.1, 1), true), Verdict::unexpected_pass);
}

TEST(Judge, WideErrorBarIsInconclusive) {
  Evidence found = evidence(1, 0.1, 1);
  found.budget.resolution = 0.19;
  EXPECT_EQ(verdict(found), Verdict::inconclusive);
  EXPECT_EQ(verdict(found, true), Verdict::inconclusive);
  found.budget.resolution = 0.21;
  EXPECT_EQ(verdict(found), Verdict::pass);
}

/// Haff's law with a budget of six times the time scale passed: the gas might not have cooled at all.
TEST(Judge, ABudgetThatReachesTheWrongAnswerIsInconclusive) {
  Evidence found = evidence(1.1, 0.1, 1);
  found.budget.systematic = 0.5;
  found.effect = 0.69;
  found.without = "no cooling";
  EXPECT_EQ(verdict(found), Verdict::inconclusive);
  EXPECT_EQ(verdict(found, true), Verdict::inconclusive);
  found.budget.reason = "finite N";
  const std::string systematic = judge(found, Confidence{two_sigma}, false).reason;
  EXPECT_NE(systematic.find("no cooling"), std::string::npos);
  EXPECT_NE(systematic.find("0.5 of it is systematic (finite N)"), std::string::npos);
  found.effect = 0.71;
  EXPECT_EQ(verdict(found), Verdict::pass);
  found.standard_error = 0.3;
  EXPECT_NE(judge(found, Confidence{two_sigma}, false).reason.find("more replicas"), std::string::npos);
}

TEST(Judge, NotFiniteIsInconclusive) {
  const double bad = std::nan("");
  EXPECT_EQ(verdict(evidence(bad, 0.1, 1)), Verdict::inconclusive);
  EXPECT_EQ(verdict(evidence(1, bad, 1)), Verdict::inconclusive);
  EXPECT_EQ(verdict(evidence(1, 0.1, std::numeric_limits<double>::infinity())), Verdict::inconclusive);
}

TEST(Judge, FewDegreesOfFreedomWidenTheBudget) {
  Evidence found = evidence(1, 0.1, 1);
  EXPECT_NEAR(judge(found, Confidence{1e-4}, false).budget, 0.1 * 3.8906, 1e-4);
  found.degrees_of_freedom = 2;
  const double p = 1 - 1e-4 / 2;  // Student's quantile has this closed form for two degrees
  const double quantile = (2 * p - 1) / std::sqrt(2 * p * (1 - p));
  EXPECT_NEAR(judge(found, Confidence{1e-4}, false).budget / (0.1 * quantile), 1, 1e-6);
}

Evidence bounded(Expectation kind, double value, double standard_error) {
  Evidence result = evidence(value, standard_error, 1);
  result.kind = kind;
  if (kind == Expectation::between) result.upper = 2;
  return result;
}

/// One side alone can be wrong: 1.69 standard errors leave 0.0455 there, where both sides would need 2.
TEST(Judge, OneSideNeedsTheWholeErrorBarOnIt) {
  for (const double side : {1.0, -1.0}) {
    const Expectation kind = side > 0 ? Expectation::at_least : Expectation::at_most;
    EXPECT_EQ(verdict(bounded(kind, 1 + side * 0.18, 0.1)), Verdict::pass) << side;
    EXPECT_EQ(verdict(bounded(kind, 1 + side * 0.16, 0.1)), Verdict::inconclusive) << side;
    EXPECT_EQ(verdict(bounded(kind, 1 - side * 0.16, 0.1)), Verdict::inconclusive) << side;
    EXPECT_EQ(verdict(bounded(kind, 1 - side * 0.18, 0.1)), Verdict::fail) << side;
    EXPECT_EQ(verdict(bounded(kind, 1 + side * 1e6, 0.1)), Verdict::pass) << side;
  }
}

TEST(Judge, BetweenHoldsBothEnds) {
  EXPECT_EQ(verdict(bounded(Expectation::between, 1.5, 0.1)), Verdict::pass);
  EXPECT_EQ(verdict(bounded(Expectation::between, 1.21, 0.1)), Verdict::pass);
  EXPECT_EQ(verdict(bounded(Expectation::between, 1.19, 0.1)), Verdict::inconclusive);
  EXPECT_EQ(verdict(bounded(Expectation::between, 1.81, 0.1)), Verdict::inconclusive);
  EXPECT_EQ(verdict(bounded(Expectation::between, 0.79, 0.1)), Verdict::fail);
  EXPECT_EQ(verdict(bounded(Expectation::between, 2.21, 0.1)), Verdict::fail);
}

TEST(Judge, ExactBoundHoldsTheBoundItself) {
  for (const Expectation kind : {Expectation::at_least, Expectation::at_most, Expectation::between})
    EXPECT_EQ(verdict(bounded(kind, 1, 0)), Verdict::pass);
  EXPECT_EQ(verdict(bounded(Expectation::at_least, 0.999, 0)), Verdict::fail);
  EXPECT_EQ(verdict(bounded(Expectation::at_most, 1.001, 0)), Verdict::fail);
  EXPECT_EQ(verdict(bounded(Expectation::between, 2.001, 0)), Verdict::fail);
}

TEST(Judge, SystematicPartMovesTheBoundOutwards) {
  Evidence found = bounded(Expectation::at_least, 0.9, 0);
  found.budget.systematic = 0.11;
  EXPECT_EQ(verdict(found), Verdict::pass);
  found.budget.systematic = 0.09;
  EXPECT_EQ(verdict(found), Verdict::fail);
  EXPECT_NEAR(judge(found, Confidence{two_sigma}, false).deviation, 0.1, 1e-12);
}

TEST(Judge, BoundThatIsNoNumberIsInconclusive) {
  const double bad = std::nan("");
  for (const Expectation kind : {Expectation::at_least, Expectation::at_most, Expectation::between}) {
    EXPECT_EQ(verdict(bounded(kind, bad, 0.1)), Verdict::inconclusive);
    EXPECT_EQ(verdict(bounded(kind, 1.5, bad)), Verdict::inconclusive);
  }
  Evidence found = bounded(Expectation::between, 1.5, 0.1);
  found.upper = bad;
  EXPECT_EQ(verdict(found), Verdict::inconclusive);
}

TEST(Judge, KnownLimitOfABoundMustLieBeyondIt) {
  EXPECT_EQ(verdict(bounded(Expectation::at_least, 0.5, 0.1), true), Verdict::expected_fail);
  EXPECT_EQ(verdict(bounded(Expectation::at_least, 1.5, 0.1), true), Verdict::unexpected_pass);
  EXPECT_EQ(verdict(bounded(Expectation::at_least, 1, 0.1), true), Verdict::inconclusive);
}

TEST(Judge, ReasonOfABoundGivesTheMeasuredNumber) {
  const std::string reason = judge(bounded(Expectation::at_least, 7.25, 0.1), {}, false).reason;
  EXPECT_NE(reason.find("7.25"), std::string::npos);
  EXPECT_NE(reason.find("at least 1 wanted"), std::string::npos);
}

TEST(Judge, NamesAndBlocking) {
  EXPECT_EQ(to_string(Verdict::unexpected_pass), "unexpected-pass");
  EXPECT_FALSE(blocks(Verdict::pass));
  EXPECT_FALSE(blocks(Verdict::expected_fail));
  EXPECT_TRUE(blocks(Verdict::inconclusive));
  EXPECT_TRUE(blocks(Verdict::unexpected_pass));
}

}  // namespace
}  // namespace sandglass::judge_test

#include "validation/judge/judge.hpp"

#include "validation/judge/quantile.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr std::array<const char*, 5> names{"pass", "fail", "inconclusive", "expected-fail",
                                           "unexpected-pass"};

/// What makes every error bar smaller.
constexpr const char* narrower = "run longer, with more particles or more replicas";

bool all_finite(const Evidence& evidence) {
  for (double number : {evidence.value, evidence.standard_error, evidence.expected, evidence.upper,
                        evidence.budget.reference, evidence.budget.systematic, evidence.budget.resolution})
    if (!std::isfinite(number)) return false;
  return true;
}

/// Of the combined error, when only the statistical part is estimated (Welch 1947, Satterthwaite 1946).
double combined_degrees_of_freedom(const Evidence& evidence) {
  const double statistical = evidence.standard_error * evidence.standard_error;
  const double reference = evidence.budget.reference * evidence.budget.reference;
  if (!(statistical > 0) || !(evidence.degrees_of_freedom > 0)) return 0;
  const double share = statistical / (statistical + reference);
  return evidence.degrees_of_freedom / (share * share);
}

/// Standard errors that one comparison may be off: the normal one, or Student's when the error is an estimate. Where one
/// side alone can be wrong, all of the probability lies there.
double coverage(const Evidence& evidence, const Confidence& confidence, double degrees_of_freedom) {
  const bool one_sided = evidence.kind == Expectation::at_least || evidence.kind == Expectation::at_most;
  const double each = shared_probability(confidence.false_alarm, evidence.comparisons);
  return two_sided_quantile(one_sided ? 2 * each : each, degrees_of_freedom);
}

/// How far the value lies on the wrong side of its bound; negative on the right side.
double beyond(const Evidence& evidence) {
  const double below = evidence.expected - evidence.value;
  switch (evidence.kind) {
    case Expectation::at_least:
      return below;
    case Expectation::at_most:
      return -below;
    case Expectation::between:
      return std::max(below, evidence.value - evidence.upper);
    case Expectation::equal:
      break;
  }
  return std::abs(below);
}

/// The part of a budget that weighs most, and what helps against it.
std::string largest_part(const Evidence& evidence, double error_bar) {
  const Budget& budget = evidence.budget;
  if (budget.systematic >= error_bar)
    return fmt::format("{:.2g} of it is systematic ({}): that part must be known better or made smaller",
                       budget.systematic, budget.reason.empty() ? "as the case states" : budget.reason);
  if (budget.reference > evidence.standard_error)
    return fmt::format("{:.2g} of it is the error of the reference: that must be known better", error_bar);
  return fmt::format("{:.2g} of it is the error bar: {}", error_bar, narrower);
}

struct Finding {
  Verdict verdict;
  std::string reason;
};

Finding two_sided(double deviation, double budget) {
  const bool inside = deviation <= budget;
  return {inside ? Verdict::pass : Verdict::fail,
          fmt::format("deviation {:.3g} {} budget {:.3g}", deviation, inside ? "within" : "exceeds", budget)};
}

/// The whole error bar must lie on one side of the bound, which the systematic part moves outwards.
Finding one_sided(const Evidence& evidence, double error_bar) {
  const double past = beyond(evidence) - evidence.budget.systematic;
  const std::string bar = error_bar > 0 ? fmt::format(" +- {:.2g}", error_bar) : "";
  const std::string what =
      fmt::format("{:.6g}{}, {} wanted", evidence.value, bar, expectation_text(evidence));
  if (past <= -error_bar) return {Verdict::pass, what};
  if (past > error_bar) return {Verdict::fail, what};
  return {Verdict::inconclusive, what + ": the error bar reaches across the bound"};
}

Verdict with_known_limit(Verdict verdict, bool known_limit) {
  if (!known_limit) return verdict;
  if (verdict == Verdict::fail) return Verdict::expected_fail;
  if (verdict == Verdict::pass) return Verdict::unexpected_pass;
  return verdict;
}
}  // namespace

Judgement judge(const Evidence& evidence, const Confidence& confidence, bool known_limit) {
  const double deviation = std::max(0.0, beyond(evidence));
  if (!all_finite(evidence))
    return {Verdict::inconclusive, std::abs(beyond(evidence)), 0,
            "the value, its error or its expectation is not a finite number"};
  const Budget& allowed = evidence.budget;
  const double width = coverage(evidence, confidence, evidence.degrees_of_freedom) * evidence.standard_error;
  const double z = coverage(evidence, confidence, combined_degrees_of_freedom(evidence));
  const double error_bar = z * std::hypot(evidence.standard_error, allowed.reference);
  const double budget = allowed.systematic + error_bar;
  if (allowed.resolution > 0 && width > allowed.resolution)
    return {
        Verdict::inconclusive, deviation, budget,
        fmt::format("the error bar {:.3g} (half width) is wider than the resolution {:.3g} that the check "
                    "needs: {}",
                    width, allowed.resolution, narrower),
        z};
  if (evidence.kind == Expectation::equal && evidence.effect > 0 && budget >= evidence.effect)
    return {Verdict::inconclusive, deviation, budget,
            fmt::format("the budget {:.3g} reaches the wrong answer, {}, {:.3g} away: {}", budget,
                        evidence.without, evidence.effect, largest_part(evidence, error_bar)),
            z};
  Finding found =
      evidence.kind == Expectation::equal ? two_sided(deviation, budget) : one_sided(evidence, error_bar);
  if (known_limit) found.reason += ", where the source says that this method must miss";
  return {with_known_limit(found.verdict, known_limit), deviation, budget, found.reason, z};
}

std::string to_string(Verdict verdict) { return names.at(static_cast<std::size_t>(verdict)); }

bool blocks(Verdict verdict) { return verdict != Verdict::pass && verdict != Verdict::expected_fail; }

}  // namespace sandglass

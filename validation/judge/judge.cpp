#include "validation/judge/judge.hpp"

#include "validation/judge/quantile.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr std::array<const char*, 5> names{"pass", "fail", "inconclusive", "expected-fail",
                                           "unexpected-pass"};

bool all_finite(const Evidence& evidence) {
  for (double number : {evidence.value, evidence.standard_error, evidence.expected, evidence.budget.reference,
                        evidence.budget.systematic, evidence.budget.resolution})
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

/// Standard errors that one comparison may be off: the normal one, or Student's when the error is an
/// estimate.
double coverage(const Evidence& evidence, const Confidence& confidence, double degrees_of_freedom) {
  return two_sided_quantile(shared_probability(confidence.false_alarm, evidence.comparisons),
                            degrees_of_freedom);
}

Verdict with_known_limit(Verdict verdict, bool known_limit) {
  if (!known_limit) return verdict;
  if (verdict == Verdict::fail) return Verdict::expected_fail;
  if (verdict == Verdict::pass) return Verdict::unexpected_pass;
  return verdict;
}
}  // namespace

Judgement judge(const Evidence& evidence, const Confidence& confidence, bool known_limit) {
  const double deviation = std::abs(evidence.value - evidence.expected);
  if (!all_finite(evidence))
    return {Verdict::inconclusive, deviation, 0,
            "the value, its error or its expectation is not a finite number"};
  const Budget& allowed = evidence.budget;
  const double width = coverage(evidence, confidence, evidence.degrees_of_freedom) * evidence.standard_error;
  const double z = coverage(evidence, confidence, combined_degrees_of_freedom(evidence));
  const double budget = allowed.systematic + z * std::hypot(evidence.standard_error, allowed.reference);
  if (allowed.resolution > 0 && width > allowed.resolution)
    return {Verdict::inconclusive, deviation, budget,
            fmt::format(
                "the error bar {:.3g} (half width) is wider than the resolution {:.3g} that the check needs",
                width, allowed.resolution),
            z};
  const bool inside = deviation <= budget;
  const Verdict verdict = with_known_limit(inside ? Verdict::pass : Verdict::fail, known_limit);
  return {verdict, deviation, budget,
          fmt::format("deviation {:.3g} {} budget {:.3g}{}", deviation, inside ? "within" : "exceeds", budget,
                      known_limit ? ", where the source says that this method must miss" : ""),
          z};
}

std::string to_string(Verdict verdict) { return names.at(static_cast<std::size_t>(verdict)); }

bool blocks(Verdict verdict) { return verdict != Verdict::pass && verdict != Verdict::expected_fail; }

}  // namespace sandglass

#pragma once

#include "validation/check/evidence.hpp"

#include <string>

namespace sandglass {

enum class Verdict { pass, fail, inconclusive, expected_fail, unexpected_pass };

/// The level at which statistical verdicts block, declared before any run.
struct Confidence {
  double false_alarm =
      1e-4;  ///< probability that one right check fails by luck; shared by its comparisons (Sidak)
};

struct Judgement {
  Verdict verdict;
  double deviation;     ///< |value - expected|; how far beyond its bound, where one side counts
  double budget;        ///< what it may be: systematic + z * sqrt(statistical^2 + reference^2)
  std::string reason;   ///< one sentence
  double coverage = 0;  ///< z: standard errors that the budget allows
};

/// The only pass/fail code of the project. `known_limit`: the source itself says that this method cannot do
/// this.
Judgement judge(const Evidence& evidence, const Confidence& confidence, bool known_limit);

/// "pass", "fail", "inconclusive", "expected-fail", "unexpected-pass"
std::string to_string(Verdict verdict);
/// Everything but pass and expected-fail blocks.
bool blocks(Verdict verdict);

}  // namespace sandglass

#pragma once

#include "sim/base/statistics.hpp"

#include <string>
#include <vector>

namespace sandglass {

/// What a value may differ from its expectation by, and why; absolute, in the units of the value.
struct Budget {
  double reference = 0;   ///< standard error of the expected value itself
  double systematic = 0;  ///< stated bound: finite N, time step, cell size, order of the theory
  std::string reason;     ///< where the systematic part comes from, in words
  double resolution =
      0;  ///< smallest deviation that the check must be able to see; wider error bars are inconclusive
};

/// Data against theory, as a figure shows it. All arrays of a set have the same length.
struct Figure {
  struct Axis {
    std::string label;
    std::string units;
    bool logarithmic = false;
  };
  struct Points {
    std::string name;
    std::vector<double> x, y, error;  ///< error: one standard error
    std::vector<double> expected;     ///< theory at the same x, for the residuals; may be empty
  };
  struct Line {
    std::string name;
    std::vector<double> x, y;
  };
  std::string title;
  Axis x, y;
  std::vector<Points> points;
  std::vector<Line> lines;
};

/// What the expectation says of the value.
enum class Expectation {
  equal,     ///< the value is `expected`
  at_least,  ///< the value is `expected` or more
  at_most,   ///< the value is `expected` or less
  between    ///< the value lies from `expected` to `upper`
};

/// What a check found: numbers, never a verdict. The value is what was measured, also where only one side counts.
struct Evidence {
  std::string check;    ///< name in the registry of checks
  std::string summary;  ///< what was compared with what, one sentence
  std::string
      law;  ///< law in the registry; empty when the expectation is a conservation law or a reference run
  std::string units = "1";  ///< "1": a pure number
  double value = 0;
  double standard_error = 0;
  double degrees_of_freedom = 0;  ///< of the standard error (Student's t); 0 when it is known, not estimated
  Expectation kind = Expectation::equal;
  double expected = 0;
  double upper = 0;  ///< the upper end, with Expectation::between alone
  Budget budget;
  double effect = 0;    ///< how far the nearest wrong answer lies from the expectation; 0: none is stated
  std::string without;  ///< that answer, in words: "no cooling"
  int comparisons = 1;  ///< independent comparisons behind the value (largest of k deviations, say)
  std::vector<Figure> figures;
};

/// An estimate with its error, and what it should be.
inline Evidence from_mean(const Mean& mean, double expected) {
  Evidence evidence;
  evidence.value = mean.value;
  evidence.standard_error = mean.standard_error;
  evidence.degrees_of_freedom = mean.degrees_of_freedom;
  evidence.expected = expected;
  return evidence;
}

/// An estimate of which only one side counts.
inline Evidence at_least(const Mean& mean, double least) {
  Evidence evidence = from_mean(mean, least);
  evidence.kind = Expectation::at_least;
  return evidence;
}

/// "equal", "at-least", "at-most", "between"
std::string to_string(Expectation kind);
/// What is expected, for a table: "0.5", "at least 0.5", "at most 1e-09", "0.5 to 2".
std::string expectation_text(const Evidence& evidence);

}  // namespace sandglass

#pragma once

namespace sandglass {

/// Probability of one comparison out of `comparisons` independent ones that share `probability` (Sidak 1967):
/// 1 - (1 - probability)^(1/comparisons).
double shared_probability(double probability, int comparisons);

/// Number of standard errors that a right value exceeds, on either side, with `probability`. Student's t with
/// `degrees_of_freedom`; the normal distribution when that is 0 (the standard error is known).
double two_sided_quantile(double probability, double degrees_of_freedom);

}  // namespace sandglass

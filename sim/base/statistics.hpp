#pragma once

#include <functional>
#include <span>
#include <vector>

namespace sandglass {

/// A mean and how well it is known.
struct Mean {
  double value = 0;
  double standard_error = 0;      ///< NaN when fewer than two samples stand behind it
  double effective_samples = 0;   ///< independent samples that would give the same error
  double degrees_of_freedom = 0;  ///< of the error itself: for Student's t
};

/// Mean of samples that are independent of each other (one number per replica, say).
Mean mean_of_independent(std::span<const double> samples);

/// Mean of one stationary series of samples that are correlated in time. The integrated autocorrelation time
/// comes from the automatic window of U. Wolff, Comput. Phys. Commun. 156, 143 (2004) with S = 1.5, and is
/// corrected for the bias of the sample mean. The series must be many correlation times long: below a hundred
/// the error comes out a few percent too small.
Mean mean_of_correlated(std::span<const double> samples);

/// Plain average of independent means of equal weight (one per replica); errors add in quadrature.
Mean average(std::span<const Mean> means);

/// A function of all replicas and its error, by leaving out one replica at a time (Quenouille 1956, Tukey
/// 1958). `function` gets the indices of the replicas to use. Bias of order 1/replicas is removed.
Mean jackknife(std::size_t replicas, const std::function<double(std::span<const std::size_t>)>& function);

/// Straight line y = intercept + slope x by weighted least squares.
struct LineFit {
  double intercept = 0, slope = 0;
  double intercept_error = 0, slope_error = 0;  ///< from the standard errors given, not from the scatter
  double chi_square = 0;
  double degrees_of_freedom = 0;  ///< points - 2
};

/// Arrays of the same length, at least two different x, standard errors above zero.
LineFit fit_line(std::span<const double> x, std::span<const double> y,
                 std::span<const double> standard_error);

}  // namespace sandglass

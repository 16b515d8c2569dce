#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace sandglass {

/// What varies by less, of its value, is constant but for rounding.
inline constexpr double rounding_share = 1e-9;

/// Samples of a quantity in time, one row for each component or replica, rows of the same length.
using Rows = std::vector<std::vector<double>>;

/// Where the steady part of a run begins: the first sample of the part whose mean is known best, the squares about its mean
/// over the square of its length being least (MSER-5: White, Cobb & Spratt 2000, Proc. Winter Simulation Conf., 755).
/// Samples are taken in fives and at most half of them is left out; 0 below twenty. Each row counts by the variance of its second half;
/// rows that do not vary or are not finite count nothing.
std::size_t steady_from(const Rows& rows);

/// Whether a series goes on changing: the means of its halves lie further apart than 4 of their standard errors, with
/// correlation in time, or it holds fewer than five independent samples. False below twenty samples, and where the halves
/// differ by rounding only (1e-9 of the value, or 1e-12).
bool drifts(std::span<const double> samples);

}  // namespace sandglass

#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

namespace sandglass {

/// Four numbers side by side in a register, one of each of four particles. What is written once for numbers and for quads
/// gives the same digits for both.
using Quad = double __attribute__((vector_size(32)));
using WholeQuad = long long __attribute__((vector_size(32)));  ///< also the type of a comparison

inline double larger(double a, double b) { return std::max(a, b); }
inline Quad larger(Quad a, Quad b) { return a < b ? b : a; }
inline double square_root(double x) { return std::sqrt(x); }
inline Quad square_root(Quad x) {
  return Quad{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}
/// Nearest whole number, ties to even. Of a size below 2^51: the sum has no room for digits behind the point.
inline Quad round_off(Quad x) {
  constexpr double no_room = 0x1.8p52;
  return (x + no_room) - no_room;
}

inline double smallest(Quad x) { return std::min({x[0], x[1], x[2], x[3]}); }
inline long long smallest(WholeQuad x) { return std::min({x[0], x[1], x[2], x[3]}); }

inline Quad read_quad(const double* numbers) {
  Quad quad;
  std::memcpy(&quad, numbers, sizeof quad);
  return quad;
}

/// Rows to columns.
inline void transpose(Quad (&m)[4]) {
  const Quad even_above = __builtin_shufflevector(m[0], m[1], 0, 4, 2, 6);
  const Quad odd_above = __builtin_shufflevector(m[0], m[1], 1, 5, 3, 7);
  const Quad even_below = __builtin_shufflevector(m[2], m[3], 0, 4, 2, 6);
  const Quad odd_below = __builtin_shufflevector(m[2], m[3], 1, 5, 3, 7);
  m[0] = __builtin_shufflevector(even_above, even_below, 0, 1, 4, 5);
  m[1] = __builtin_shufflevector(odd_above, odd_below, 0, 1, 4, 5);
  m[2] = __builtin_shufflevector(even_above, even_below, 2, 3, 6, 7);
  m[3] = __builtin_shufflevector(odd_above, odd_below, 2, 3, 6, 7);
}

}  // namespace sandglass

#pragma once

namespace sandglass {

/// Largest area fraction of equal disks, pi/(2 sqrt 3), and volume fraction of equal spheres, pi/(3 sqrt 2).
constexpr double close_packing(int dimension) { return dimension == 2 ? 0.9069 : 0.7405; }

/// Random close packing (Mueller 2001).
constexpr double random_close_packing(int dimension) { return dimension == 2 ? 0.82 : 0.64; }

/// Where the equilibrium fluid begins to freeze (disks: Bernard & Krauth 2011; spheres: Hoover & Ree 1968).
constexpr double freezing_fraction(int dimension) { return dimension == 2 ? 0.70 : 0.494; }

}  // namespace sandglass

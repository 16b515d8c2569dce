#pragma once

namespace sandglass::law {

/// A heap on a plane in two dimensions, of incomplete layers that end in kinks: Alonso & Herrmann 1996, Mueller 2001
/// (3.14)-(3.17). Symmetric about x = 0; the surface never reaches h = 0.
struct Heap {
  double height;  ///< h_m, at the middle [length]
  double slope;   ///< m, of an ideal side without kinks
  double
      kink_length;  ///< l/r: length of a kink over the probability to stop there [length]; 0 makes a triangle
};

/// Distance from the middle at which the surface is at `h`, 0 < h <= h_m: (h_m - h)/m + (l/r) ln(h_m/h) [length].
double heap_distance(const Heap& heap, double h);

/// Surface at a distance from the middle [length], the inverse of heap_distance: h = (m l/r) W(e^s) with Lambert's W
/// and s = h_m/(m l/r) + ln(h_m/(m l/r)) - x/(l/r). A triangle, 0 beyond its foot, when l/r = 0.
double heap_surface(const Heap& heap, double distance);

/// Area under both sides, h_m^2/m + 2 (l/r) h_m [length^2].
double heap_area(const Heap& heap);

/// Height of a heap of given area, m (sqrt((l/r)^2 + A/m) - l/r) [length]: the square root of the triangle when large,
/// A r/(2l) when small.
double heap_height(double area, double slope, double kink_length);

}  // namespace sandglass::law

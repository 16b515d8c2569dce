#pragma once

#include "sim/base/column.hpp"

#include <cmath>

// The columns that particles may have beside position and velocity, each declared once: name in files, units, type, and
// what a particle has that comes without. How a column travels: docs/particle-columns.md.

namespace sandglass::column {

/// Identity: never changes and is never given twice in a run.
inline constexpr ColumnKey<std::uint64_t> id{"id", "1"};
/// Index into the species of the scene.
inline constexpr ColumnKey<std::uint8_t> species{"species", "1"};
/// Those of its species: in files alone, where species differ in them.
inline constexpr ColumnKey<double> diameter{"diameter", "length", 1};
inline constexpr ColumnKey<double> mass{"mass", "mass", 1};
/// Angular velocity.
template <int D>
inline constexpr ColumnKey<Spin<D>> spin{"spin", "time^-1"};
/// Real particles that one simulated particle stands for.
inline constexpr ColumnKey<double> weight{"weight", "1", 1};
/// Time of the last contact.
inline constexpr ColumnKey<double> last_contact{"last-contact", "time", -HUGE_VAL};

}  // namespace sandglass::column

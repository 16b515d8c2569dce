#pragma once

#include <cstdint>
#include <limits>

// Names and numbers of the record's layout (docs/file-formats.md), shared by the functions that write and
// read it.

namespace sandglass::schema {

/// Of the /sandglass group. A greater minor adds names that older readers may ignore; a greater major breaks
/// them.
inline constexpr int version_major = 1;
inline constexpr int version_minor = 4;
/// Of the H5MD convention, https://www.nongnu.org/h5md/h5md.html
inline constexpr int h5md_major = 1;
inline constexpr int h5md_minor = 1;

/// Stands in padded places: the value, time and coordinates there are NaN.
inline constexpr std::uint64_t no_step = std::numeric_limits<std::uint64_t>::max();
inline constexpr std::uint64_t no_number = std::numeric_limits<std::uint64_t>::max();
inline constexpr std::uint8_t no_byte = std::numeric_limits<std::uint8_t>::max();
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

namespace names {

inline constexpr const char* root = "sandglass";
inline constexpr const char* version = "schema";
inline constexpr const char* scene = "scene";
inline constexpr const char* provenance = "provenance";
inline constexpr const char* seed = "seed";
inline constexpr const char* counters = "counters";
inline constexpr const char* timings = "timings";
inline constexpr const char* series = "series";
inline constexpr const char* estimates = "estimates";
inline constexpr const char* state = "state";
inline constexpr const char* memory = "memory";
inline constexpr const char* order = "order";
inline constexpr const char* samples = "samples";
inline constexpr const char* value = "value";
inline constexpr const char* time = "time";
inline constexpr const char* step = "step";
inline constexpr const char* standard_error = "standard_error";
inline constexpr const char* effective_samples = "effective_samples";
inline constexpr const char* start_time = "start_time";
inline constexpr const char* drifts = "drifts";
inline constexpr const char* warnings = "warnings";
inline constexpr const char* changes = "changes";
inline constexpr const char* broken = "broken";

inline constexpr const char* particles = "particles";
inline constexpr const char* all = "all";
inline constexpr const char* box = "box";
inline constexpr const char* position = "position";
inline constexpr const char* velocity = "velocity";
inline constexpr const char* units = "units";
inline constexpr const char* count = "count";
inline constexpr const char* observables = "observables";
inline constexpr const char* parameters = "parameters";

}  // namespace names

}  // namespace sandglass::schema

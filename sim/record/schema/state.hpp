#pragma once

#include "sim/record/hdf5/reader.hpp"
#include "sim/record/hdf5/writer.hpp"
#include "sim/record/record.hpp"

#include <map>
#include <string>
#include <vector>

namespace sandglass::schema {

/// One scalar dataset per entry.
void write_scalars(const hdf5::Writer& group, const std::map<std::string, double>& scalars);
std::map<std::string, double> read_scalars(const hdf5::Reader& group);

/// seed[R] and counters/<name>[R]; NaN where a replica lacks a counter.
void write_replicas(const hdf5::Writer& group, const std::vector<Replica>& replicas);
/// Replicas with seed and counters; their series are read by read_series().
std::vector<Replica> read_replicas(const hdf5::Reader& group);

/// The unfinished replica of a checkpoint: every double comes back bit for bit.
void write_state(const hdf5::Writer& group, const State& state, int dimension);
State read_state(const hdf5::Reader& group, int dimension);

}  // namespace sandglass::schema

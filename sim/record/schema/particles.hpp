#pragma once

#include "sim/record/hdf5/reader.hpp"
#include "sim/record/hdf5/writer.hpp"
#include "sim/record/record.hpp"

#include <span>

namespace sandglass::schema {

/// H5MD /h5md: version, author, creator.
void write_convention(const hdf5::Writer& file, const Provenance& provenance);

/// H5MD box: dimension, boundary, edges.
void write_box(const hdf5::Writer& group, const Record& record);
void read_box(const hdf5::Reader& group, Record& record);

/// step[T] and time[T] of an H5MD element.
void write_clock(const hdf5::Writer& element, std::span<const Frame> frames);

/// H5MD elements position, velocity and one per column (which all or no frames with particles hold): {value[T][N][D], step,
/// time}; frames with fewer particles are padded and count[T] says how many are real. Nothing is written for an empty
/// trajectory.
void write_trajectory(const hdf5::Writer& group, std::span<const Frame> frames, int dimension);
std::vector<Frame> read_trajectory(const hdf5::Reader& group, int dimension);

}  // namespace sandglass::schema

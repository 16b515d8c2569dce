#pragma once

#include "sim/record/hdf5/reader.hpp"
#include "sim/record/hdf5/writer.hpp"
#include "sim/record/record.hpp"

#include <span>

namespace sandglass::schema {

/// The columns that the frames hold. Throws hdf5::Failure when only some of those with particles hold one.
std::vector<ColumnInfo> columns_of(std::span<const Frame> frames);

/// value[T][N], or value[T][N][K] of a column of vectors, and its units. Places without a particle hold NaN or the greatest
/// whole number, and so says the fill value.
void write_column(const hdf5::Writer& element, const ColumnInfo& info, std::span<const Frame> frames,
                  std::size_t most);

/// Groups beside positions and velocities that hold a column.
std::vector<std::string> column_links(const hdf5::Reader& group);
/// Adds the column to each of the frames, which hold `counts` particles.
void read_column(const hdf5::Reader& group, const std::string& link, std::span<const std::uint64_t> counts,
                 std::span<Frame> frames);

}  // namespace sandglass::schema

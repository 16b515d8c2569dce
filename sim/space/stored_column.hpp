#pragma once

#include "sim/base/columns.hpp"
#include "sim/space/scatter.hpp"

#include <memory>

namespace sandglass {

/// A column of a particle store, whatever its type: two buffers for the sort.
class StoredColumn {
 public:
  virtual ~StoredColumn() = default;
  virtual ColumnView view() const = 0;
  /// Particles beyond those it holds get the initial value of the column.
  virtual void resize(std::size_t particles) = 0;
  /// Keeps memory for as many particles.
  virtual void shrink(std::size_t room) = 0;
  /// As std::rotate.
  virtual void rotate(std::size_t first, std::size_t middle, std::size_t last) = 0;
  /// Overwrites the values from `first` on.
  virtual void write(std::size_t first, const ColumnView& values) = 0;
  virtual void sort(const Column<CellPlace>& places, const std::uint32_t* begin) = 0;
  virtual std::size_t bytes() const = 0;
};

/// For 1 to 3 components. Throws InputError for others.
std::unique_ptr<StoredColumn> make_stored_column(const ColumnInfo& info);

}  // namespace sandglass

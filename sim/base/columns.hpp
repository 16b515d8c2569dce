#pragma once

#include "sim/base/column.hpp"

#include <span>
#include <type_traits>
#include <variant>
#include <vector>

namespace sandglass {

/// A column that somebody else holds.
struct ColumnView {
  ColumnInfo info;
  const void* numbers = nullptr;
  std::size_t particles = 0;
};

/// What a simulation shows of its columns, by declaration.
class ColumnViews {
 public:
  /// An empty column is an absent one.
  template <class T>
  void add(const ColumnKey<T>& key, std::type_identity_t<std::span<const T>> values) {
    if (!values.empty()) list_.push_back({key, values.data(), values.size()});
  }
  void add(ColumnView view) {
    if (view.particles > 0) list_.push_back(std::move(view));
  }
  /// Empty when the column is absent.
  template <class T>
  std::span<const T> get(const ColumnKey<T>& key) const {
    for (const ColumnView& view : list_)
      if (view.info.fits(key)) return {static_cast<const T*>(view.numbers), view.particles};
    return {};
  }
  auto begin() const { return list_.begin(); }
  auto end() const { return list_.end(); }

 private:
  std::vector<ColumnView> list_;
};

using Numbers = std::variant<std::vector<std::uint8_t>, std::vector<std::uint64_t>, std::vector<double>>;

/// Numbers of one kind, as many as asked for, all alike.
Numbers make_numbers(Number number, std::size_t count, double value);

/// A column with its values, particle by particle.
struct NamedColumn {
  ColumnInfo info;
  Numbers numbers;

  std::size_t particles() const;
  const void* data() const;
  ColumnView view() const { return {info, data(), particles()}; }
};

/// The values of the particles at these places, in their order; a place may come several times.
NamedColumn pick(const ColumnView& column, std::span<const std::uint32_t> places);

/// Columns of the same particles: what a method starts from, a frame shows and a checkpoint keeps beside positions and
/// velocities. Values are read and written through the declaration of their column, which knows their type.
class Columns {
 public:
  template <class T>
  bool has(const ColumnKey<T>& key) const {
    return find(key) != nullptr;
  }
  /// Empty when the column is absent.
  template <class T>
  std::span<const T> get(const ColumnKey<T>& key) const {
    const NamedColumn* found = find(key);
    if (found == nullptr) return {};
    return {static_cast<const T*>(found->data()), found->particles()};
  }
  template <class T>
  std::span<T> edit(const ColumnKey<T>& key) {
    const std::span<const T> values = get(key);
    return {const_cast<T*>(values.data()), values.size()};
  }
  template <class T>
  void set(const ColumnKey<T>& key, std::type_identity_t<std::span<const T>> values) {
    set(ColumnView{key, values.data(), values.size()});
  }
  template <class T>
  void append(const ColumnKey<T>& key, const std::type_identity_t<T>& value) {
    append(ColumnView{key, &value, 1});
  }

  /// Without their types: for files and copies.
  void set(const ColumnView& view);
  void set(NamedColumn column);
  /// A column that is not there yet begins with this.
  void append(const ColumnView& view);
  void remove(const std::string& name);
  const std::vector<NamedColumn>& all() const { return list_; }
  /// Null when absent. Throws InputError when a column of this name holds something else.
  const NamedColumn* find(const ColumnInfo& info) const;

 private:
  std::vector<NamedColumn> list_;
};

}  // namespace sandglass

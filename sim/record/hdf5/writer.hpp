#pragma once

#include "sim/record/hdf5/handle.hpp"
#include "sim/record/hdf5/type.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sandglass::hdf5 {

/// Noise does not compress: particle data are stored plain, padded series deflated (when they are large).
enum class Packing { plain, deflated };

/// Writes into one group. Every function throws Failure with the reason. T is double, std::uint64_t, std::uint8_t (data only) or int (attributes only).
class Writer {
 public:
  explicit Writer(Handle group) : group_(std::move(group)) {}

  Writer group(const std::string& name) const;

  /// Dataset of shape `extents`, row major; `absent` is what readers take for no value. Throws Failure when the
  /// number of values differs from the shape.
  template <class T>
  void numbers(const std::string& name, const Extents& extents, std::span<const T> values,
               Packing packing = Packing::plain, const T* absent = nullptr) const;
  /// Scalar dataset.
  template <class T>
  void number(const std::string& name, T value) const {
    numbers<T>(name, {}, std::span<const T>(&value, 1));
  }
  /// Scalar dataset of one UTF-8 string of fixed length (parallel HDF5 cannot write strings of variable
  /// length).
  void text(const std::string& name, std::string_view value) const;

  template <class T>
  void attribute(const std::string& name, const std::vector<T>& values) const;
  void attribute(const std::string& name, int value) const;
  void attribute(const std::string& name, std::string_view value) const;
  void attribute(const std::string& name, const char* value) const {
    attribute(name, std::string_view(value));
  }
  /// One-dimensional attribute of strings; nothing is written for an empty list.
  void attribute(const std::string& name, const std::vector<std::string>& values) const;

  /// A second name for what `source` knows as `source_name`.
  void link(const std::string& name, const Writer& source, const std::string& source_name) const;

 private:
  Handle group_;
};

}  // namespace sandglass::hdf5

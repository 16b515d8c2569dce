#pragma once

#include "sim/base/vector.hpp"

#include <cstdint>
#include <string>

namespace sandglass {

/// What the numbers of a column are: bytes (a species), whole (an id) or real.
enum class Number { byte, whole, real };

/// What is known of a column without its type: enough to sort, to save and to write it.
struct ColumnInfo {
  std::string name;   ///< in files and messages
  std::string units;  ///< in mass, length and time; "1" for a pure number
  Number number = Number::real;
  std::size_t components = 1;  ///< numbers that each particle has
  bool vector = false;         ///< in files with an axis for the components, even for one of them
  double initial = 0;          ///< each of them, for a particle that comes without

  /// Two columns of one name must be the same column.
  bool fits(const ColumnInfo& other) const {
    return name == other.name && number == other.number && components == other.components;
  }
};

/// How a C++ type is made of numbers.
template <class T>
struct NumbersOf;

template <>
struct NumbersOf<std::uint8_t> {
  using Scalar = std::uint8_t;
  static constexpr Number number = Number::byte;
  static constexpr std::size_t components = 1;
  static constexpr bool vector = false;
};
template <>
struct NumbersOf<std::uint64_t> {
  using Scalar = std::uint64_t;
  static constexpr Number number = Number::whole;
  static constexpr std::size_t components = 1;
  static constexpr bool vector = false;
};
template <>
struct NumbersOf<double> {
  using Scalar = double;
  static constexpr Number number = Number::real;
  static constexpr std::size_t components = 1;
  static constexpr bool vector = false;
};
template <int N>
struct NumbersOf<Eigen::Matrix<double, N, 1>> {
  using Scalar = double;
  static constexpr Number number = Number::real;
  static constexpr std::size_t components = N;
  static constexpr bool vector = true;
};

/// The declaration of a column of values of type T. All that knows a column knows it by this one object.
template <class T>
struct ColumnKey {
  const char* name;
  const char* units;
  double initial = 0;

  operator ColumnInfo() const {
    static_assert(sizeof(T) == NumbersOf<T>::components * sizeof(typename NumbersOf<T>::Scalar));
    return {name, units, NumbersOf<T>::number, NumbersOf<T>::components, NumbersOf<T>::vector, initial};
  }
};

}  // namespace sandglass

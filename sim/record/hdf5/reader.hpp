#pragma once

#include "sim/base/column.hpp"
#include "sim/record/hdf5/checksum.hpp"
#include "sim/record/hdf5/handle.hpp"
#include "sim/record/hdf5/type.hpp"

#include <string>
#include <vector>

namespace sandglass::hdf5 {

/// A dataset in memory, row major.
template <class T>
struct Array {
  Extents extents;
  std::vector<T> values;
};

/// Reads from one group. Every function throws Failure naming the place and the reason.
class Reader {
 public:
  Reader(Handle group, std::string path, Unsealed unsealed = Unsealed::accept)
      : group_(std::move(group)), path_(std::move(path)), unsealed_(unsealed) {}

  Reader group(const std::string& name) const;
  /// The same group; every dataset must have its checksum.
  Reader sealed_group(const std::string& name) const;
  bool has(const std::string& name) const;
  bool has_attribute(const std::string& name) const;
  /// Names of everything in the group, sorted.
  std::vector<std::string> names() const;

  /// T is double, std::uint64_t or std::uint8_t.
  template <class T>
  Array<T> numbers(const std::string& name) const;
  /// The same, but throws Failure when the shape is not `extents`.
  template <class T>
  std::vector<T> numbers(const std::string& name, const Extents& extents) const;
  template <class T>
  T number(const std::string& name) const {
    return numbers<T>(name, Extents{}).front();
  }
  /// Which of these holds the numbers as they are stored.
  Number number_of(const std::string& name) const;
  std::string text(const std::string& name) const;

  /// T is double, int or std::uint64_t. Empty when there is no such attribute.
  template <class T>
  std::vector<T> attribute(const std::string& name) const;
  /// Strings of fixed or variable length. Empty when there is no such attribute.
  std::vector<std::string> words(const std::string& name) const;
  /// A single string; "" when there is no such attribute.
  std::string word(const std::string& name) const;

  /// Throws Failure: "'/place/name': reason".
  [[noreturn]] void fail(const std::string& name, const std::string& reason) const;

 private:
  Handle group_;
  std::string path_;
  Unsealed unsealed_;
};

}  // namespace sandglass::hdf5

#pragma once

#include "sim/scene/scene.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace sandglass {

/// A value as TOML. Numbers are written with the fewest digits that read back to the same bits.
std::string write_value(bool value);
std::string write_value(int value);
std::string write_value(std::uint64_t value);
std::string write_value(double value);
std::string write_value(const std::string& value);
std::string write_value(const std::array<double, 2>& value);
std::string write_value(const Duration& value);
std::string write_value(const Cadence& value);
std::string write_value(const TimeStep& value);
std::string write_value(const ShearWave& value);

template <class Value>
std::string write_value(const std::vector<Value>& values) {
  std::string text = "[";
  for (const Value& value : values) text += (text.size() > 1 ? ", " : "") + write_value(value);
  text += "]";
  return text;
}

/// Lines of TOML; an empty optional leaves no line.
class Lines {
 public:
  void header(const std::string& header) { text_ += "\n" + header + "\n"; }
  template <class Value>
  void add(const std::string& key, const Value& value) {
    text_ += key + " = " + write_value(value) + "\n";
  }
  template <class Value>
  void add(const std::string& key, const std::optional<Value>& value) {
    if (value) add(key, *value);
  }
  /// key = { name = value, ... }, the values as write_value() gives them.
  void add_table(const std::string& key, const std::vector<std::pair<std::string, std::string>>& entries);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace sandglass

#include "sim/scene/text/write_value.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
std::string escaped(char character) {
  switch (character) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    default:
      break;
  }
  const auto code = static_cast<unsigned char>(character);
  return code < 0x20 || code == 0x7f ? fmt::format("\\u{:04x}", code) : std::string(1, character);
}

std::string entry(const std::string& key, const std::string& value) {
  return "{ " + key + " = " + value + " }";
}
}  // namespace

std::string write_value(bool value) { return value ? "true" : "false"; }
std::string write_value(int value) { return std::to_string(value); }
std::string write_value(std::uint64_t value) { return std::to_string(value); }

std::string write_value(double value) {
  const std::string text = fmt::format("{}", value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

std::string write_value(const std::string& value) {
  std::string text = "\"";
  for (const char character : value) text += escaped(character);
  text += '"';
  return text;
}

std::string write_value(const std::array<double, 2>& value) {
  return fmt::format("[{}, {}]", write_value(value[0]), write_value(value[1]));
}

std::string write_value(const Duration& value) {
  if (value.time) return entry("time", write_value(*value.time));
  if (value.steps) return entry("steps", write_value(*value.steps));
  return entry("collisions-per-particle", write_value(value.collisions.value_or(0)));
}

std::string write_value(const Cadence& value) {
  if (value.unit == Cadence::Unit::time) return entry("time", write_value(value.every));
  if (value.unit == Cadence::Unit::steps)
    return entry("steps", write_value(static_cast<std::uint64_t>(value.every)));
  return entry("collisions-per-particle", write_value(value.every));
}

std::string write_value(const TimeStep& value) {
  if (value.fixed) return write_value(*value.fixed);
  if (value.cell_fraction) return entry("cell-fraction", write_value(*value.cell_fraction));
  return entry("collisions-per-particle", write_value(value.collisions.value_or(0)));
}

std::string write_value(const ShearWave& value) {
  return fmt::format("{{ amplitude = {}, periods = {} }}", write_value(value.amplitude), value.periods);
}

void Lines::add_table(const std::string& key,
                      const std::vector<std::pair<std::string, std::string>>& entries) {
  std::string table;
  for (const auto& [name, value] : entries) table += (table.empty() ? " " : ", ") + name + " = " + value;
  text_ += key + " = {" + table + " }\n";
}

}  // namespace sandglass

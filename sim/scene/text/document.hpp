#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sandglass {

/// Where something stands in a text; both 1-based, 0 when it stands nowhere.
struct Place {
  int line = 0;
  int column = 0;
  auto operator<=>(const Place&) const = default;
};

/// One value of a TOML text with its place: the only form of TOML that the rest of the room sees.
struct Node {
  enum class Kind { text, whole, number, flag, date, list, table };

  Kind kind = Kind::table;
  Place place;      ///< of the value; of the header for a table
  std::string key;  ///< when it is an entry of a table
  Place key_place;
  std::string text;
  std::int64_t whole = 0;
  double number = 0;
  bool flag = false;
  std::vector<Node> items;  ///< of a list or table, in the order of the text
};

/// Throws InputError with file, line and column of the first syntax error.
Node parse_document(const std::string& text, const std::string& file_name);

}  // namespace sandglass

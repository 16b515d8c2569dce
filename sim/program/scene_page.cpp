#include "sim/program/scene_page.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>

namespace sandglass::program {

namespace {
std::string trimmed(std::string text) {
  const auto blank = [](unsigned char c) { return std::isspace(c) != 0; };
  text.erase(text.begin(), std::ranges::find_if_not(text, blank));
  while (!text.empty() && blank(static_cast<unsigned char>(text.back()))) text.pop_back();
  return text;
}

/// Without the marks of code, and with the words of a link instead of the link.
std::string plain(const std::string& cell) {
  std::string text;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (cell[i] == '`' || cell[i] == '[') continue;
    if (cell.compare(i, 2, "](") == 0) {
      i = std::min(cell.find(')', i), cell.size());
      continue;
    }
    if (cell[i] != ']') text += cell[i];
  }
  return trimmed(text);
}

/// The cells of a row; a bar within code does not part cells.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::string cell;
  bool code = false;
  for (const char c : line.substr(1)) {
    code = code != (c == '`');
    if (c != '|' || code) {
      cell += c;
      continue;
    }
    cells.push_back(trimmed(cell));
    cell.clear();
  }
  return cells;
}

/// Keys in their cell: `a`, `b` share one row.
std::vector<std::string> keys_of(const std::string& cell) {
  std::vector<std::string> keys;
  for (std::size_t open = cell.find('`'); open != std::string::npos;) {
    const std::size_t close = cell.find('`', open + 1);
    if (close == std::string::npos) break;
    keys.push_back(cell.substr(open + 1, close - open - 1));
    open = cell.find('`', close + 1);
  }
  return keys;
}

std::string section_of(const std::string& heading) {
  const std::size_t open = heading.find('['), close = heading.find(']');
  if (open == std::string::npos || close == std::string::npos)
    return plain(heading.substr(heading.find(' ')));
  const std::size_t first = heading.find_first_not_of('[', open);
  return heading.substr(first, close - first);
}

void add_row(const std::vector<std::string>& heads, const std::vector<std::string>& cells,
             PageSection& section) {
  for (const std::string& key : keys_of(cells.front())) {
    KeyEntry entry{key, {}};
    for (std::size_t i = 1; i < cells.size() && i < heads.size(); ++i)
      entry.cells.emplace_back(heads[i], plain(cells[i]));
    section.keys.push_back(entry);
  }
}
}  // namespace

std::vector<PageSection> read_scene_page(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw InputError("cannot read '" + path + "', which describes the keys of a scene");
  std::vector<PageSection> page;
  std::vector<std::string> heads;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("##")) {
      page.push_back({section_of(line), {}});
      heads.clear();
    } else if (line.starts_with("| key ")) {
      heads = cells_of(line);
    } else if (!line.starts_with("|")) {
      heads.clear();
    } else if (!heads.empty() && line.starts_with("| `") && !page.empty()) {
      add_row(heads, cells_of(line), page.back());
    }
  }
  std::erase_if(page, [](const PageSection& section) { return section.keys.empty(); });
  return page;
}

}  // namespace sandglass::program

#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

// For the tests: spoils a text at random, from a fixed seed.

namespace sandglass {

inline const std::vector<std::string> scraps = {"[",
                                                "]",
                                                "{",
                                                "}",
                                                "\"",
                                                "'",
                                                "\n",
                                                "=",
                                                ".",
                                                ",",
                                                "#",
                                                "-",
                                                "_",
                                                "\\",
                                                "0",
                                                "9",
                                                "e",
                                                "nan",
                                                "inf",
                                                "-1",
                                                "1e400",
                                                "true",
                                                "[[",
                                                "]]",
                                                "2020-01-01",
                                                "\xff",
                                                "\xc3\xa9",
                                                std::string(1, '\0'),
                                                "99999999999999999999",
                                                "0x",
                                                "x"};

class Mutator {
 public:
  explicit Mutator(unsigned seed) : engine_(seed) {}

  std::string spoil(std::string text) {
    const std::size_t edits = 1 + below(4);
    for (std::size_t edit = 0; edit < edits; ++edit)
      text = below(2) ? spoil_characters(text) : spoil_lines(text);
    return text;
  }

 private:
  /// std::uniform_int_distribution is not the same on every library; the bias of a remainder is no matter
  /// here.
  std::size_t below(std::size_t bound) { return engine_() % bound; }

  std::string spoil_characters(std::string text) {
    if (text.empty()) return text;
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(8);
    switch (below(3)) {
      case 0:
        return text.erase(at, length);
      case 1:
        return text.insert(at, text.substr(at, length));
      default:
        return text.replace(at, below(2), scraps[below(scraps.size())]);
    }
  }

  std::string spoil_lines(const std::string& text) {
    std::vector<std::string> lines{""};
    for (const char character : text) {
      lines.back() += character;
      if (character == '\n') lines.emplace_back();
    }
    const std::size_t from = below(lines.size()), to = below(lines.size());
    switch (below(3)) {
      case 0:
        lines[from].clear();
        break;
      case 1:
        lines[to] += lines[from];
        break;
      default:
        std::swap(lines[from], lines[to]);
        break;
    }
    std::string joined;
    for (const std::string& line : lines) joined += line;
    return joined;
  }

  std::mt19937 engine_;
};

}  // namespace sandglass

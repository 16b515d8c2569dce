#pragma once

#include "sim/base/error.hpp"
#include "sim/scene/scene.hpp"

#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// For the tests: a good scene, an edit that spoils it, and what must then be said.

namespace sandglass {

struct BadEdit {
  std::string name;
  std::string find;  ///< occurs once in the good scene; empty: the edit stands at its end
  std::string replace;
  std::string place;               ///< "line:column" of the one error expected
  std::vector<std::string> words;  ///< all in its message
};

inline void PrintTo(const BadEdit& edit, std::ostream* stream) { *stream << edit.name; }

inline std::string spoiled(std::string text, const BadEdit& edit) {
  if (edit.find.empty()) return text + edit.replace;
  const std::size_t at = text.find(edit.find);
  EXPECT_NE(at, std::string::npos) << "the good scene lacks " << edit.find;
  EXPECT_EQ(text.find(edit.find, at + 1), std::string::npos) << "the good scene has twice " << edit.find;
  return text.replace(at, edit.find.size(), edit.replace);
}

/// Exactly one error, at its place, with its words: an error neither hides nor brings others along.
inline void expect_refused(const std::string& good, const BadEdit& edit) {
  ASSERT_NO_THROW(read_scene_text(good, "scene.toml"));
  const std::string text = spoiled(good, edit);
  try {
    read_scene_text(text, "scene.toml");
    FAIL() << "accepted:\n" << text;
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U) << error.what();
    EXPECT_THAT(error.what(), testing::StartsWith("scene.toml:" + edit.place + ": error: "));
    for (const std::string& word : edit.words) EXPECT_THAT(error.what(), testing::HasSubstr(word));
  }
}

inline std::string edit_name(const testing::TestParamInfo<BadEdit>& info) { return info.param.name; }

}  // namespace sandglass

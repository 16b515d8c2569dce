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

struct Fault {
  std::string name;
  std::string find;  ///< occurs once in the good scene; empty: the edit stands at its end
  std::string replace;
  std::string place;               ///< "line:column" of the one error expected
  std::vector<std::string> words;  ///< all in its message
};

inline void PrintTo(const Fault& fault, std::ostream* stream) { *stream << fault.name; }

inline std::string spoiled(std::string text, const Fault& fault) {
  if (fault.find.empty()) return text + fault.replace;
  const std::size_t at = text.find(fault.find);
  EXPECT_NE(at, std::string::npos) << "the good scene lacks " << fault.find;
  EXPECT_EQ(text.find(fault.find, at + 1), std::string::npos) << "the good scene has twice " << fault.find;
  return text.replace(at, fault.find.size(), fault.replace);
}

/// Exactly one error, at its place, with its words: an error neither hides nor brings others along.
inline void expect_fault(const std::string& good, const Fault& fault) {
  ASSERT_NO_THROW(read_scene_text(good, "scene.toml"));
  const std::string text = spoiled(good, fault);
  try {
    read_scene_text(text, "scene.toml");
    FAIL() << "accepted:\n" << text;
  } catch (const InputError& error) {
    ASSERT_EQ(error.diagnostics().size(), 1U) << error.what();
    EXPECT_THAT(error.what(), testing::StartsWith("scene.toml:" + fault.place + ": error: "));
    for (const std::string& word : fault.words) EXPECT_THAT(error.what(), testing::HasSubstr(word));
  }
}

inline std::string fault_name(const testing::TestParamInfo<Fault>& info) { return info.param.name; }

}  // namespace sandglass

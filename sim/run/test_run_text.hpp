#pragma once

#include "sim/run/run.hpp"

#include <string>

#include <gtest/gtest.h>

// For the tests: scenes as text, changed and run.

namespace sandglass {

/// With the one place of `find` replaced.
inline std::string edited(std::string text, const std::string& find, const std::string& replace) {
  const std::size_t at = text.find(find);
  EXPECT_NE(at, std::string::npos) << find;
  return text.replace(at, find.size(), replace);
}

inline Record run_text(const std::string& text, const std::string& fault = "") {
  RunOptions options;
  options.planted_fault = fault;
  return run_scene(read_scene_text(text, "scene.toml"), options);
}

}  // namespace sandglass

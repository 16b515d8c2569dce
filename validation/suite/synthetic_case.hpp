#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

namespace sandglass {

/// A case in a temporary folder, for tests: small enough to run in a fraction of a second.
class SyntheticCase {
 public:
  explicit SyntheticCase(const std::string& more = "", const std::string& point = "") {
    std::filesystem::create_directories(folder());
    write("scene.toml",
          "title = \"small\"\n[run]\nseed = 3\nduration = { collisions-per-particle = 20.0 "
          "}\n[domain]\ndimension = 2\n"
          "size = [100.0, 100.0]\n[[species]]\ncount = 200\n[method]\ncells = [5, 5]\n"
          "time-step = { collisions-per-particle = 0.1 }\n"
          "[[observe]]\nwhat = \"energy\"\nevery = { collisions-per-particle = 1.0 }\n"
          "[[observe]]\nwhat = \"collisions\"\nevery = { collisions-per-particle = 1.0 }\n");
    write("README.md", "# Small\n");
    write(
        "case.toml",
        "name = \"small\"\ntopic = \"test\"\nsummary = \"s\"\nquestion = \"q\"\n[[point]]\nname = \"one\"\n" +
            point + "\n[[variant]]\nname = \"dsmc\"\n[[check]]\ncheck = \"energy-conservation\"\n" + more);
  }
  ~SyntheticCase() { std::filesystem::remove_all(root_); }
  SyntheticCase(const SyntheticCase&) = delete;
  SyntheticCase& operator=(const SyntheticCase&) = delete;

  /// The variants of all cases.
  void write_variants(const std::string& text) const { std::ofstream(root_ / "variants.toml") << text; }
  /// The case in other words.
  void write_case(const std::string& text) const {
    write("case.toml", "name = \"small\"\ntopic = \"test\"\nsummary = \"s\"\nquestion = \"q\"\n" + text);
  }

  std::filesystem::path root() const { return root_; }
  std::filesystem::path folder() const { return root_ / "test" / "small"; }

 private:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder() / name) << text;
  }
  std::filesystem::path root_ =
      std::filesystem::temp_directory_path() / ("sandglass-case-" + std::to_string(::getpid()));
};

}  // namespace sandglass

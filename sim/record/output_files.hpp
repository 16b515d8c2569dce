#pragma once

#include "sim/record/atomic_file.hpp"

#include <string>
#include <vector>

namespace sandglass {

/// A file that a command is going to write.
struct OutputFile {
  std::string path;
  Existing existing = Existing::keep;
  std::string remedy = "";  ///< for a file that is to be kept, after "exists already; "
};

/// The files that one command writes, claimed before its work starts, so that hours of it do not end at a file that
/// cannot be written: never an input of the command, another of its outputs, or a file that is no regular one; never
/// one that exists, unless asked for; and none that another running command has claimed. A claim is the lock of a file
/// `<path>.lock`, which goes with it and which the system gives back when a process is killed.
class OutputFiles {
 public:
  explicit OutputFiles(std::vector<std::string> inputs) : inputs_(std::move(inputs)) {}
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /// Returns the leftovers of commands that were killed while they wrote this file, which are removed.
  /// Throws InputError naming the path and the remedy; RunError where the system refuses.
  std::vector<std::string> claim(const OutputFile& output);

 private:
  struct Lock {
    std::string path;
    int descriptor;
  };

  void refuse_own_files(const std::string& path) const;
  void lock(const std::string& path);

  std::vector<std::string> inputs_, claimed_;
  std::vector<Lock> locks_;
};

}  // namespace sandglass

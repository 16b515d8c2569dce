#pragma once

#include <cassert>
#include <stdexcept>
#include <string>
#include <vector>

namespace sandglass {

/// One thing wrong with what the user gave: where it stands, what is wrong and what to do.
struct Diagnostic {
  std::string file;
  int line = 0;    ///< 1-based; 0 when the error has no place in the file
  int column = 0;  ///< 1-based; 0 as above
  std::string message;

  /// "file:line:column: error: message"
  std::string text() const;
};

/// The user's input cannot be used (exit code 2). Carries every error found, not only the first.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string message);
  explicit InputError(std::vector<Diagnostic> diagnostics);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  std::vector<Diagnostic> diagnostics_;
};

/// The run itself broke: disk full, a state that is not a number, ... (exit code 3).
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace sandglass

/// Broken precondition of a function: the caller's mistake. Debug builds only.
#define SANDGLASS_EXPECT(condition) assert((condition) && "precondition")
/// Internal error: cannot happen unless this code is wrong. Debug builds only.
#define SANDGLASS_ENSURE(condition) assert((condition) && "internal fault")

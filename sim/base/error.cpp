#include "sim/base/error.hpp"

namespace sandglass {

namespace {
std::string join(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += diagnostic.text();
  }
  return text;
}
}  // namespace

std::string Diagnostic::text() const {
  std::string place = file;
  if (line > 0) place += ':' + std::to_string(line) + ':' + std::to_string(column);
  return (place.empty() ? "" : place + ": ") + "error: " + message;
}

InputError::InputError(std::string message) : InputError({Diagnostic{"", 0, 0, std::move(message)}}) {}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(join(diagnostics)), diagnostics_(std::move(diagnostics)) {}

}  // namespace sandglass

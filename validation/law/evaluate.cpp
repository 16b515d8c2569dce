#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "validation/law/law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace sandglass::law {

namespace {
using Errors = std::vector<Diagnostic>;

void blame(Errors& errors, std::string message) { errors.push_back({"", 0, 0, std::move(message)}); }

void check_names(const Law& law, const Arguments& arguments, Errors& errors) {
  std::vector<std::string> allowed;
  for (const Parameter& parameter : law.parameters) allowed.push_back(parameter.name);
  for (const auto& [name, value] : arguments)
    if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
      blame(errors, unknown_word(fmt::format("argument of law '{}'", law.name), name, allowed));
}

/// Space dimension if it is given and sound, else 0: then nothing is said about arguments that hang on it.
int given_dimension(const Arguments& arguments) {
  const auto found = arguments.find("dimension");
  if (found == arguments.end()) return 0;
  return found->second == 2 ? 2 : found->second == 3 ? 3 : 0;
}

bool allowed_value(const Parameter& parameter, double value) {
  return value >= parameter.low && value <= parameter.high && std::isfinite(value) &&
         (parameter.step == 0 || std::fmod(value, parameter.step) == 0);
}

void check_given(const Parameter& parameter, double value, int dimension, Errors& errors) {
  if (parameter.dimension != 0 && dimension != 0 && parameter.dimension != dimension) {
    blame(errors, fmt::format("'{}' belongs to dimension={}; leave it out with dimension={}", parameter.name,
                              parameter.dimension, dimension));
  } else if (!allowed_value(parameter, value)) {
    blame(errors,
          fmt::format("{}={} is out of range; allowed: {}", parameter.name, value, range_text(parameter)));
  }
}

void fill_missing(const Law& law, const Parameter& parameter, int dimension, Arguments& full,
                  Errors& errors) {
  if (parameter.dimension != 0 && parameter.dimension != dimension) return;
  if (parameter.fallback)
    full[parameter.name] = *parameter.fallback;
  else
    blame(errors, fmt::format("law '{}' needs '{}' ({}); add {}=VALUE, allowed: {}", law.name, parameter.name,
                              parameter.summary, parameter.name, range_text(parameter)));
}

std::string spell(const Arguments& arguments) {
  std::string text;
  for (const auto& [name, value] : arguments) text += fmt::format(" {}={}", name, value);
  return text;
}
}  // namespace

std::string range_text(const Parameter& parameter) {
  constexpr double huge = std::numeric_limits<double>::max();
  const auto [low, high] = std::pair(parameter.low, parameter.high);
  if (parameter.step > 0 && high == low + parameter.step) return fmt::format("{} or {}", low, high);
  if (parameter.step > 0) return fmt::format("{} to {} in steps of {}", low, high, parameter.step);
  if (high < huge) return fmt::format("{} to {}", low, high);
  if (low == std::numeric_limits<double>::min()) return "a positive number";
  return low > -huge ? fmt::format("{} or more", low) : "a finite number";
}

double evaluate(const Law& law, const Arguments& arguments) {
  Errors errors;
  check_names(law, arguments, errors);
  Arguments full = arguments;
  const int dimension = given_dimension(arguments);
  for (const Parameter& parameter : law.parameters) {
    const auto found = arguments.find(parameter.name);
    if (found != arguments.end())
      check_given(parameter, found->second, dimension, errors);
    else
      fill_missing(law, parameter, dimension, full, errors);
  }
  if (!errors.empty()) throw InputError(std::move(errors));
  const double value = law.evaluate(full);
  if (!std::isfinite(value))
    throw InputError(fmt::format("law '{}' has no finite value at{}; it holds for {}", law.name, spell(full),
                                 law.validity));
  return value;
}

}  // namespace sandglass::law

#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace sandglass::law {

/// One argument of a law, as the command line names it ("area-fraction").
struct Parameter {
  std::string name;
  std::string units;
  std::string summary;
  double low;   ///< smallest allowed value
  double high;  ///< largest allowed value
  std::optional<double> fallback;  ///< used when the argument is not given
};

using Arguments = std::map<std::string, double>;

/// An analytic result: what it says, where it comes from and where it holds.
struct Law {
  std::string name;      ///< hyphenated, spelled out: "haff-time-scale"
  std::string summary;   ///< one sentence
  std::string source;    ///< author, year, equation
  std::string units;
  std::string validity;  ///< range and order of the theory
  std::vector<Parameter> parameters;
  std::function<double(const Arguments&)> evaluate;
};

const std::vector<Law>& all_laws();
/// Throws InputError naming the nearest spelling.
const Law& find_law(const std::string& name);
/// Checks names and ranges, fills in fallbacks and evaluates. Throws InputError naming key, range and remedy.
double evaluate(const Law& law, const Arguments& arguments);

}  // namespace sandglass::law

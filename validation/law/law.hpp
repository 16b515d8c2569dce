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
  double low;                                     ///< smallest allowed value
  double high;                                    ///< largest allowed value
  std::optional<double> fallback = std::nullopt;  ///< used when the argument is not given
  int step = 0;                                   ///< 0: any number; k: only multiples of k
  int dimension = 0;  ///< the space dimension that the argument belongs to; 0 for any
};

using Arguments = std::map<std::string, double>;

/// An analytic result: what it says, where it comes from and where it holds.
struct Law {
  std::string name;     ///< hyphenated, spelled out: "haff-time-scale"
  std::string summary;  ///< one sentence
  std::string source;   ///< author, year, equation
  std::string units;
  std::string validity;  ///< range and order of the theory
  std::vector<Parameter> parameters;
  std::function<double(const Arguments&)> evaluate;  ///< unchecked: call sandglass::law::evaluate instead
};

const std::vector<Law>& all_laws();
/// Throws InputError naming the nearest spelling.
const Law& find_law(const std::string& name);
/// Checks names and ranges, fills in fallbacks and evaluates. Throws InputError naming key, range and remedy,
/// every error at once, and also when the law has no finite value there.
double evaluate(const Law& law, const Arguments& arguments);
/// The allowed values in words: "0 to 1", "positive", "2 or 3".
std::string range_text(const Parameter& parameter);

}  // namespace sandglass::law

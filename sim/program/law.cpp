#include "sim/base/error.hpp"
#include "sim/program/options.hpp"
#include "sim/program/table.hpp"
#include "validation/law/example.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandglass::program {

namespace {

law::Arguments read_arguments(const std::vector<std::string>& words) {
  law::Arguments arguments;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    const std::string key = word.substr(0, equals);
    double value = 0;
    const char* begin = word.data() + std::min(equals, word.size() - 1) + 1;
    const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
    if (equals == std::string::npos || error != std::errc() || end != word.data() + word.size())
      throw InputError(fmt::format("'{}' is not key=number; write for example restitution=0.9", word));
    if (!arguments.emplace(key, value).second) throw InputError(fmt::format("'{}' is given twice", key));
  }
  return arguments;
}

bool must_be_given(const law::Parameter& parameter) { return !parameter.fallback; }

std::string fallback_text(const law::Parameter& parameter) {
  if (parameter.fallback) return fmt::format("{}", *parameter.fallback);
  return parameter.dimension == 0 ? "needed" : fmt::format("needed in {}D", parameter.dimension);
}

/// Values for what must be given, in round numbers.
std::string try_text(const law::Law& law) {
  const law::Arguments example = law::example_arguments(law);
  std::string text = "sandglass law " + law.name;
  for (const law::Parameter& parameter : law.parameters)
    if (must_be_given(parameter) && example.contains(parameter.name))
      text += fmt::format(" {}={:.2g}", parameter.name, example.at(parameter.name));
  return text;
}

/// What the law takes and a line to try it with.
void describe(const law::Law& law) {
  fmt::print("{}  [{}]\n  {}\n  source: {}\n  valid: {}\n\n", law.name, law.units, law.summary, law.source,
             law.validity);
  std::vector<std::vector<std::string>> rows = {{"argument", "units", "allowed", "default", "meaning"}};
  for (const law::Parameter& parameter : law.parameters)
    rows.push_back({parameter.name, parameter.units, law::range_text(parameter), fallback_text(parameter),
                    parameter.summary});
  fmt::print("{}\ntry: {}\n", columns(rows), try_text(law));
}

}  // namespace

int evaluate_law(const Options& options) {
  const law::Law& found = law::find_law(options.subject);
  if (options.words.empty() && !options.json && std::ranges::any_of(found.parameters, must_be_given)) {
    describe(found);
    return all_well;
  }
  const double value = law::evaluate(found, read_arguments(options.words));
  if (options.json) {
    const nlohmann::json json = {{"name", found.name},         {"value", value},
                                 {"units", found.units},       {"source", found.source},
                                 {"validity", found.validity}, {"summary", found.summary}};
    fmt::print("{}\n", json.dump(2));
    return all_well;
  }
  fmt::print("{} = {:.15g}  [{}]\n  {}\n  source: {}\n  valid: {}\n", found.name, value, found.units,
             found.summary, found.source, found.validity);
  return all_well;
}

}  // namespace sandglass::program

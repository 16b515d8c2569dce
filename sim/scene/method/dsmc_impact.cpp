#include "sim/scene/method/dsmc.hpp"
#include "sim/scene/text/bounds.hpp"

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double least = -100, most = 0.999;  // p(b) = a/(1 - c b^2) has no integral from c = 1 on

const Words<ImpactDistribution>& impact_words() {
  static const Words<ImpactDistribution> words = {{"uniform", ImpactDistribution::uniform},
                                                  {"fitted", ImpactDistribution::fitted}};
  return words;
}

void read_coefficient(Table& table, Curve& curve) {
  const std::string key = "impact-coefficient";
  if (!table.has(key))
    return table.report_missing(key,
                                "c of p(b) = a/(1 - c b^2): a number, or "
                                "{ collisions-per-particle = [0, 80], value = [0, 0.4] }");
  if (!table.is(key, Node::Kind::table)) {
    double value = 0;
    table.read(key, value);
    curve = {{0}, {value}};
    return;
  }
  Table inner = *table.table(key);
  inner.require("collisions-per-particle", curve.at, "rising numbers, for example [0, 80]");
  inner.require("value", curve.value, "c at each, for example [0, 0.4]");
  inner.finish();
}
}  // namespace

void read_impact(Table& table, DsmcOptions& dsmc) {
  table.read_word("impact", "distribution of impact parameters", dsmc.impact, impact_words());
  if (dsmc.impact == ImpactDistribution::fitted)
    read_coefficient(table, dsmc.impact_coefficient);
  else if (table.clean("impact"))
    table.refuse("impact-coefficient", "is used with impact = \"fitted\" only");
}

void write_impact(Lines& lines, const DsmcOptions& dsmc) {
  lines.add("impact", word_of(impact_words(), dsmc.impact));
  if (dsmc.impact == ImpactDistribution::uniform) return;
  lines.add_table("impact-coefficient", {{"collisions-per-particle", write_value(dsmc.impact_coefficient.at)},
                                         {"value", write_value(dsmc.impact_coefficient.value)}});
}

void check_impact(const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  if (dsmc.impact == ImpactDistribution::uniform) return;
  const std::string path = "method.impact-coefficient";
  if (!check_curve(dsmc.impact_coefficient, path, "collisions-per-particle", "value", diagnostics)) return;
  for (const double value : dsmc.impact_coefficient.value)
    check_bounds(diagnostics, path, value, between(least, most));
}

bool check_curve(const Curve& curve, const std::string& path, const std::string& places,
                 const std::string& values, Diagnostics& diagnostics) {
  if (!diagnostics.clean(path)) return false;
  const auto wrong = [&](const std::string& what) {
    diagnostics.report(path, shown(path) + ' ' + what);
    return false;
  };
  if (curve.at.empty()) return wrong("is empty; give at least one point");
  if (curve.at.size() != curve.value.size())
    return wrong(fmt::format("has {} numbers in '{}' and {} in '{}'; give one for each", curve.at.size(),
                             places, curve.value.size(), values));
  for (std::size_t i = 0; i < curve.at.size(); ++i) {
    if (!check_bounds(diagnostics, path, curve.at[i], at_least(0))) return false;
    if (i > 0 && curve.at[i] <= curve.at[i - 1])
      return wrong(
          fmt::format("has {} after {} in '{}'; they must rise", curve.at[i], curve.at[i - 1], places));
  }
  return true;
}

}  // namespace sandglass

#include "sim/scene/species/diameters.hpp"

#include <cmath>
#include <functional>
#include <numeric>

#include <boost/math/special_functions/erf.hpp>

namespace sandglass {

namespace {
constexpr std::uint64_t most_classes = 100;

enum class Kind { uniform, normal, lognormal, list };

const Words<Kind>& kind_words() {
  static const Words<Kind> words = {{"uniform", Kind::uniform},
                                    {"normal", Kind::normal},
                                    {"lognormal", Kind::lognormal},
                                    {"list", Kind::list}};
  return words;
}

/// Of the standard normal distribution.
double normal_quantile(double probability) {
  return std::sqrt(2) * boost::math::erf_inv(2 * probability - 1);
}

Diameters classes_of(const std::function<double(double)>& quantile, std::size_t classes) {
  const double count = static_cast<double>(classes);
  Diameters diameters{{}, std::vector<double>(classes, 1 / count)};
  for (std::size_t i = 0; i < classes; ++i)
    diameters.values.push_back(quantile((static_cast<double>(i) + 0.5) / count));
  return diameters;
}

bool all_positive(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double number) { return number > 0 && std::isfinite(number); });
}

std::optional<Diameters> read_uniform(Table& table, std::size_t classes) {
  double low = 0, high = 0;
  table.require("low", low, "the smallest diameter");
  table.require("high", high, "the largest diameter");
  if (!table.clean()) return {};
  if (low > 0 && low < high && std::isfinite(high)) return uniform_diameters(low, high, classes);
  table.refuse("low", "must be above 0 and below 'high'");
  return {};
}

std::optional<Diameters> read_bell(Table& table, std::size_t classes, bool normal) {
  double mean = 0, deviation = 0;
  table.require("mean", mean, "the mean diameter");
  table.require("deviation", deviation, "the standard deviation of the diameters");
  if (!table.clean()) return {};
  if (!(mean > 0 && deviation > 0 && std::isfinite(mean) && std::isfinite(deviation))) {
    table.refuse("deviation", "must be above 0, as 'mean' must");
    return {};
  }
  const Diameters diameters =
      normal ? normal_diameters(mean, deviation, classes) : lognormal_diameters(mean, deviation, classes);
  if (all_positive(diameters.values)) return diameters;
  table.refuse("deviation", "is so wide that diameters are not above 0; narrow it, or use \"lognormal\"");
  return {};
}

std::optional<Diameters> read_list(Table& table) {
  Diameters list;
  table.require("values", list.values, "the diameters, for example values = [0.8, 1.0, 1.2]");
  table.read("shares", list.shares);
  if (!table.clean()) return {};
  if (list.shares.empty()) list.shares.assign(list.values.size(), 1);
  if (list.values.empty() || list.values.size() > most_classes || !all_positive(list.values))
    table.refuse("values", "must be 1 to 100 diameters above 0");
  else if (list.shares.size() != list.values.size() || !all_positive(list.shares))
    table.refuse("shares", "must be as many numbers above 0 as there are 'values'");
  if (!table.clean()) return {};
  const double all = std::accumulate(list.shares.begin(), list.shares.end(), 0.0);
  for (double& share : list.shares) share /= all;
  return list;
}
}  // namespace

double Diameters::mean() const {
  return std::inner_product(values.begin(), values.end(), shares.begin(), 0.0);
}

Diameters uniform_diameters(double low, double high, std::size_t classes) {
  return classes_of([&](double probability) { return low + (high - low) * probability; }, classes);
}

Diameters normal_diameters(double mean, double deviation, std::size_t classes) {
  return classes_of([&](double probability) { return mean + deviation * normal_quantile(probability); },
                    classes);
}

/// ln d is normal with the variance ln(1 + deviation^2/mean^2) and the mean ln(mean) less half of that.
Diameters lognormal_diameters(double mean, double deviation, std::size_t classes) {
  const double variance = std::log1p(deviation * deviation / (mean * mean));
  return classes_of(
      [&](double probability) {
        return mean * std::exp(std::sqrt(variance) * normal_quantile(probability) - variance / 2);
      },
      classes);
}

std::optional<Diameters> read_diameters(Table& species) {
  Table table = *species.table("diameter");
  std::optional<Kind> kind;
  Kind word = Kind::list;
  table.read_word("distribution", "distribution", word, kind_words());
  if (!table.has("distribution"))
    table.report_missing("distribution", "one of " + list_words(names_of(kind_words())));
  if (table.clean("distribution") && table.has("distribution")) kind = word;
  std::uint64_t classes = 16;
  if (kind && *kind != Kind::list) table.read("classes", classes);
  if (classes < 2 || classes > most_classes) {
    table.refuse("classes", "must be 2 to 100");
    classes = 2;
  }
  std::optional<Diameters> diameters;
  if (kind == Kind::uniform) diameters = read_uniform(table, classes);
  if (kind == Kind::normal || kind == Kind::lognormal)
    diameters = read_bell(table, classes, kind == Kind::normal);
  if (kind == Kind::list) diameters = read_list(table);
  if (kind) table.finish();
  return table.clean() ? diameters : std::nullopt;
}

}  // namespace sandglass

#include "sim/base/vector.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/sedimentation.hpp"
#include "validation/law/enskog.hpp"
#include "validation/law/sinking_column.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Dense>

// The swing of the centre of mass with which a column of gas comes to rest under gravity (Kawasaki 1986, section 3.1).

namespace sandglass {

namespace {
using Some = Sedimentation::Some;

bool is_of_one_species(const Scene& scene) { return is_sedimentation(scene) && scene.species.size() == 1; }

bool is_mixture(const Scene& scene) { return is_sedimentation(scene) && scene.species.size() > 1; }

law::SinkingColumn sinking(const Subject& subject, const Sedimentation& column) {
  const double temperature = subject.scene().initial.temperature;
  return {subject.gas(temperature), column.column().gravity, column.part(0, temperature).height,
          column.column().freedom};
}

/// Of the law, at the times of the samples; centres of hard particles start from where they touch the floor.
std::vector<double> law_heights(const law::Fall& fall, const std::vector<double>& time, double reach) {
  std::vector<double> heights;
  for (const double t : time) {
    const auto i = std::min(static_cast<std::size_t>(t / fall.step), fall.height.size() - 2);
    const double part = t / fall.step - static_cast<double>(i);
    heights.push_back(reach + fall.height[i] + part * (fall.height[i + 1] - fall.height[i]));
  }
  return heights;
}

/// Height of the centre of mass at each sample, mean of some replicas.
std::vector<double> mean_heights(const std::vector<std::vector<double>>& heights, Some replicas) {
  std::vector<double> sum(heights.front().size(), 0.0);
  for (const std::size_t replica : replicas)
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += heights[replica][i];
  for (double& value : sum) value /= static_cast<double>(replicas.size());
  return sum;
}

struct Lowest {
  double time, height;
};

/// Least squares with a parabola over what lies within `half_width` of `centre`: its lowest point. NaN without one.
Lowest bottom(const std::vector<double>& time, const std::vector<double>& height, double centre,
              double half_width) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < time.size(); ++i) {
    const double x = (time[i] - centre) / half_width;
    if (std::abs(x) > 1) continue;
    const Eigen::Vector3d row(1, x, x * x);
    normal += row * row.transpose();
    right += row * height[i];
  }
  const Eigen::Vector3d fit = normal.ldlt().solve(right);
  if (!(fit[2] > 0)) return {std::numeric_limits<double>::quiet_NaN(), height.front()};
  const double x = -fit[1] / (2 * fit[2]);
  return {centre + half_width * x, fit[0] - fit[2] * x * x};
}

/// The lowest point of the first period: a parabola about the lowest sample, a quarter of a half period to each side.
Lowest lowest(const std::vector<double>& time, const std::vector<double>& height, double half_period) {
  std::size_t least = 0;
  for (std::size_t i = 0; i < time.size() && time[i] < 2 * half_period; ++i)
    if (height[i] < height[least]) least = i;
  return bottom(time, height, time[least], half_period / 4);
}

class Swing {
 public:
  explicit Swing(const Subject& subject)
      : column_(subject), half_period_(law::first_bounce(sinking(subject, column_)).time) {
    for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
      heights_.push_back(column_.heights(replica));
    time_ = subject.series(0, "centre-of-mass").time;
    time_.resize(static_cast<std::size_t>(std::upper_bound(time_.begin(), time_.end(), 5 * half_period_) -
                                          time_.begin()));
    law_ = law_heights(law::fall_of_column(sinking(subject, column_), 5 * half_period_), time_,
                       column_.reach(0));
  }

  const Sedimentation& column() const { return column_; }
  double time(Some replicas) const { return first_lowest(measured(replicas)).time; }
  double law_time() const { return first_lowest(law_).time; }
  /// How far the lowest point lies below rest, over how far the start lay above it.
  double depth(Some replicas) const { return depth(measured(replicas), replicas); }
  double law_depth() const { return depth(law_, column_.all()); }

  Figure figure() const {
    const std::vector<double> mean = measured(column_.all());
    const double rest = column_.rest_height(column_.temperature(column_.all()));
    Figure::Points points{"measured", time_, mean, {}, law_};
    for (std::size_t i = 0; i < time_.size(); ++i) {
      std::vector<double> values;
      for (const std::vector<double>& one : heights_) values.push_back(one[i]);
      points.error.push_back(mean_of_independent(values).standard_error);
    }
    return {"Fall of the centre of mass",
            {"time", "time", false},
            {"height", "length", false},
            {std::move(points)},
            {{"Navier, Stokes and Fourier", time_, law_}, {"at rest", {0, time_.back()}, {rest, rest}}}};
  }

 private:
  std::vector<double> measured(Some replicas) const {
    std::vector<double> mean = mean_heights(heights_, replicas);
    mean.resize(time_.size());
    return mean;
  }
  Lowest first_lowest(const std::vector<double>& heights) const {
    return lowest(time_, heights, half_period_);
  }
  double depth(const std::vector<double>& heights, Some replicas) const {
    const double rest = column_.rest_height(column_.temperature(replicas));
    return (rest - first_lowest(heights).height) / (heights.front() - rest);
  }

  Sedimentation column_;
  double half_period_;
  std::vector<std::vector<double>> heights_;
  std::vector<double> time_, law_;
};

/// The equations of the law hold to second order in the mean free path against the length of the wave.
double burnett(const Subject& subject, const Sedimentation& column) {
  return std::pow(std::numbers::pi * law::mean_free_path(subject.gas(1)) / column.height(), 2);
}

Evidence sedimentation_swing(const Subject& subject, const law::Arguments&) {
  const Swing swing(subject);
  Evidence evidence = from_mean(
      jackknife(subject.replicas(), [&](Some replicas) { return swing.time(replicas); }), swing.law_time());
  evidence.units = "time";
  evidence.budget.systematic = evidence.expected * burnett(subject, swing.column());
  evidence.budget.reason = "mean free path against the length of the wave, to second order";
  evidence.figures.push_back(swing.figure());
  return evidence;
}

/// What is left of the fall has been damped as exp(-Gamma t): an error in Gamma counts with Gamma t.
Evidence sedimentation_overshoot(const Subject& subject, const law::Arguments&) {
  const Swing swing(subject);
  Evidence evidence = from_mean(
      jackknife(subject.replicas(), [&](Some replicas) { return swing.depth(replicas); }), swing.law_depth());
  evidence.budget.systematic =
      evidence.expected * (1 - std::log(evidence.expected)) * burnett(subject, swing.column());
  evidence.budget.reason =
      "mean free path against the length of the wave, to second order, in period and damping";
  evidence.figures.push_back(swing.figure());
  return evidence;
}

/// Mean height of a species, over the samples from one time to another.
double mean_height(const Subject& subject, const Sedimentation& column, std::size_t replica, std::size_t kind,
                   double from, double to) {
  const Series& series = subject.series(replica, "species-density");
  const std::size_t bins = series.quantity.shape.at(column.axis());
  double moment = 0, sum = 0;
  for (std::size_t sample = 0; sample < series.samples(); ++sample) {
    if (series.time[sample] < from || series.time[sample] > to) continue;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      const double density = series.value[(sample * bins + bin) * column.species() + kind];
      sum += density;
      moment += density * (static_cast<double>(bin) + 0.5) * column.height() / static_cast<double>(bins);
    }
  }
  return moment / sum;
}

/// The same of the law, its density taken to the middles of the bins.
double rest_height(const Sedimentation& column, std::size_t kind, double temperature, std::size_t bins) {
  const law::Column own = column.part(kind, temperature);
  const double thickness = column.height() / static_cast<double>(bins);
  double moment = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const double low = static_cast<double>(bin) * thickness - column.reach(kind);
    moment += (law::barometric_fraction(own, low + thickness) - law::barometric_fraction(own, low)) *
              (static_cast<double>(bin) + 0.5) * thickness;
  }
  return moment;
}

std::size_t lightest(const Sedimentation& column) {
  const auto& species = column.column().species;
  const auto lighter = [](const auto& a, const auto& b) { return a.mass < b.mass; };
  return static_cast<std::size_t>(std::min_element(species.begin(), species.end(), lighter) -
                                  species.begin());
}

Evidence sedimentation_light_species(const Subject& subject, const law::Arguments& numbers) {
  const Sedimentation column(subject);
  const std::size_t kind = lightest(column),
                    bins = subject.series(0, "species-density").quantity.shape.at(column.axis());
  std::vector<double> depths;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica)
    depths.push_back(
        (rest_height(column, kind, column.temperature(replica), bins) -
         mean_height(subject, column, replica, kind, numbers.at("from-time"), numbers.at("to-time"))) /
        column.height());
  return at_least(mean_of_independent(depths), 0);
}
}  // namespace

std::vector<CheckInfo> sedimentation_fall_checks() {
  const std::vector<std::string> needs = {"energy", "centre-of-mass"};
  return {
      {"sedimentation-swing",
       "time at which the centre of mass of a sinking gas is lowest",
       "sedimentation-swing-time",
       needs,
       true,
       {},
       is_of_one_species,
       sedimentation_swing},
      {"sedimentation-overshoot",
       "how far the centre of mass sinks below its place at rest, over its fall to there",
       "sedimentation-overshoot",
       needs,
       false,
       {},
       is_of_one_species,
       sedimentation_overshoot},
      {"sedimentation-light-species",
       "how far the lightest species lies below its place at rest between two times, over the height of the "
       "column",
       "sedimentation-height",
       {"energy", "centre-of-mass", "species-density"},
       false,
       {law::Parameter{"from-time", "time", "samples before it are left out", 0, 1e12},
        law::Parameter{"to-time", "time", "samples after it are left out", 0, 1e12}},
       is_mixture,
       sedimentation_light_species}};
}

}  // namespace sandglass

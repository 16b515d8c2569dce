#include "validation/check/clustering_excess.hpp"

#include "validation/check/clustering_reference.hpp"
#include "validation/law/haff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sandglass {

namespace {
constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
}

ClusteringExcess::ClusteringExcess(const Subject& subject) {
  const double scale = law::haff_time_scale(subject.gas(subject.scene().initial.temperature));
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Series& energy = subject.series(replica, "energy");
    time_.emplace_back();
    value_.emplace_back();
    for (std::size_t i = 0; i < energy.samples(); ++i) {
      time_.back().push_back(energy.time[i] / scale);
      value_.back().push_back(energy.value[i] / energy.value[0] /
                              law::haff_energy_ratio(energy.time[i], scale));
    }
  }
}

double ClusteringExcess::last() const {
  double least = INFINITY;
  for (const std::vector<double>& times : time_) least = std::min(least, times.back());
  return least;
}

double ClusteringExcess::at(std::size_t replica, double time) const {
  const std::vector<double>&t = time_[replica], &y = value_[replica];
  const auto after = std::lower_bound(t.begin(), t.end(), time * (1 - 1e-9));
  if (after == t.end()) return kNever;
  const auto i = static_cast<std::size_t>(after - t.begin());
  if (i == 0) return y.front();
  const double share = std::min(1.0, (time - t[i - 1]) / (t[i] - t[i - 1]));
  return std::exp((1 - share) * std::log(y[i - 1]) + share * std::log(y[i]));
}

Mean ClusteringExcess::mean_at(double time) const {
  std::vector<double> values;
  for (std::size_t replica = 0; replica < replicas(); ++replica) values.push_back(at(replica, time));
  return mean_of_independent(values);
}

Mean ClusteringExcess::passage(bool falls, const std::function<double(double)>& mark) const {
  const std::vector<double>& times = time_.front();
  return jackknife(replicas(), [&](std::span<const std::size_t> chosen) {
    double before = 0;
    for (std::size_t i = 0; i < times.size() && times[i] <= last(); ++i) {
      double sum = 0;
      for (std::size_t replica : chosen) sum += at(replica, times[i]);
      const double over = sum / static_cast<double>(chosen.size()) / mark(times[i]) - 1;
      if (i > 0 && (falls ? over <= 0 : over >= 0))
        return times[i - 1] + (times[i] - times[i - 1]) * before / (before - over);
      before = over;
    }
    return kNever;
  });
}

Figure ClusteringExcess::figure() const {
  Figure figure;
  figure.title = "Energy of the clustering gas over Haff's law";
  figure.x = {"t/t0", "1", true};
  figure.y = {"E/E0 (1 + t/t0)^2", "1", true};
  Figure::Points points{"measured", {}, {}, {}, {}};
  Figure::Line haff{"Haff", {}, {}}, reference{"event-driven, N = 99856", {}, {}};
  for (double time = 0.1; time <= last(); time *= 1.25) {
    const Mean mean = mean_at(time);
    points.x.push_back(time);
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
    haff.x.push_back(time);
    haff.y.push_back(1);
    if (time > clustering_reference().back().time) continue;
    reference.x.push_back(time);
    reference.y.push_back(clustering_excess(time));
  }
  figure.points.push_back(std::move(points));
  figure.lines = {std::move(haff), std::move(reference)};
  return figure;
}

}  // namespace sandglass

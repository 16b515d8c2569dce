#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/collapse_reference.hpp"
#include "validation/check/falling.hpp"
#include "validation/check/families.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

// Dissipative disks fall to the floor of a box (Mueller 2001, section 2.3.2, figure 2.7): centre of mass against that of
// hard disks. The source: until t = 0.05 all methods agree, from 0.1 on DSMC is too low.

namespace sandglass {

namespace {
std::size_t sample_at(const Fall& fall, double time) {
  for (std::size_t i = 0; i < fall.time.size(); ++i)
    if (std::abs(fall.time[i] - time) <= 1e-6 * time) return i;
  throw InputError(fmt::format(
      "no sample at time {}, where the reference has a point: sample every 0.01 and run so long", time));
}

/// Until the floor is felt each replica is followed from its own start, whose free fall is taken off.
enum class Height { above_fall, above_floor };

Mean height_at(const Subject& subject, double time, Height kind) {
  std::vector<double> heights;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Fall fall = fall_of(subject, replica);
    const double fallen =
        kind == Height::above_fall ? law::falling_height(particles_at(subject, fall, 0), time) : 0;
    heights.push_back(fall.height[sample_at(fall, time)] - fallen);
  }
  return mean_of_independent(heights);
}

/// Measured less reference.
Evidence height_evidence(const Subject& subject, const CollapsePoint& point, Height kind) {
  Evidence evidence = from_mean(height_at(subject, point.time, kind), 0);
  evidence.value -= point.height;
  evidence.budget.reference = point.standard_error;
  evidence.units = "length";
  evidence.summary =
      fmt::format("centre of mass above that of hard disks; furthest off at time {}", point.time);
  return evidence;
}

/// NaN counts as the furthest.
double distance(const Evidence& evidence) {
  return std::isnan(evidence.value) ? INFINITY : std::abs(evidence.value);
}

Figure height_figure(const std::vector<Evidence>& found, const std::vector<CollapsePoint>& reference,
                     Height kind) {
  Figure figure{kind == Height::above_fall ? "Centre of mass above its free fall" : "Centre of mass",
                {"time", "time", false},
                {"height", "length", false},
                {},
                {}};
  Figure::Points measured{"measured", {}, {}, {}, {}};
  Figure::Line line{"event-driven reference", {}, {}};
  for (std::size_t i = 0; i < reference.size(); ++i) {
    measured.x.push_back(reference[i].time);
    measured.y.push_back(reference[i].height + found[i].value);
    measured.error.push_back(found[i].standard_error);
    measured.expected.push_back(reference[i].height);
    line.x.push_back(reference[i].time);
    line.y.push_back(reference[i].height);
  }
  figure.points.push_back(std::move(measured));
  figure.lines.push_back(std::move(line));
  return figure;
}

/// Points before `from` are shown and not judged.
Evidence furthest(const Subject& subject, std::vector<CollapsePoint> reference, Height kind, double from) {
  const double end = subject.series(0, "centre-of-mass").time.back() * (1 + 1e-9);
  std::erase_if(reference, [end](const CollapsePoint& point) { return point.time > end; });
  if (reference.empty())
    throw InputError("the run ends before the reference begins: run to time 0.1 at least");
  std::vector<Evidence> found;
  for (const CollapsePoint& point : reference) found.push_back(height_evidence(subject, point, kind));
  const auto first = std::ranges::lower_bound(reference, from * (1 - 1e-9), {}, &CollapsePoint::time);
  const auto judged = std::span(found).subspan(static_cast<std::size_t>(first - reference.begin()));
  if (judged.empty())
    throw InputError(fmt::format("no point of the reference from time {} to the end of the run", from));
  Evidence worst = *std::ranges::max_element(
      judged, [](const Evidence& a, const Evidence& b) { return distance(a) < distance(b); });
  worst.comparisons = static_cast<int>(judged.size());
  worst.figures.push_back(height_figure(found, reference, kind));
  return worst;
}

Evidence collapse_start(const Subject& subject, const law::Arguments&) {
  return furthest(subject, collapse_lift(subject.species().restitution), Height::above_fall, 0);
}

Evidence collapse_end(const Subject& subject, const law::Arguments& numbers) {
  return furthest(subject, collapse_height(subject.species().restitution), Height::above_floor,
                  numbers.at("from"));
}

bool near(double a, double b) { return std::abs(a - b) <= 1e-9 * b; }

/// What the reference holds for.
bool collapses_like_reference(const Scene& scene) {
  if (!falls_to_floor(scene) || scene.domain.dimension != 2 || !scene.walls.empty()) return false;
  const Species& disk = scene.species.front();
  return near(scene.domain.size[0], 0.02) && near(scene.domain.size[1], 0.04) && near(disk.diameter, 0.001) &&
         disk.count == 100u && near(-scene.gravity[1], 9.81) &&
         (near(disk.restitution, 0.9) || near(disk.restitution, 0.5));
}
}  // namespace

std::vector<CheckInfo> collapse_checks() {
  const std::vector<std::string> needs = {"centre-of-mass", "momentum", "wall-force"};
  return {
      {"collapse-start",
       "centre of mass of collapsing disks until t = 0.05 less that of hard disks, event-driven reference",
       "",
       needs,
       false,
       {},
       collapses_like_reference,
       collapse_start},
      {"collapse-end",
       "centre of mass of collapsing disks from t = 0.1 on less that of hard disks, event-driven reference",
       "",
       needs,
       false,
       {law::Parameter{"from", "time", "points before it are shown and not judged", 0, 1e12, 0}},
       collapses_like_reference,
       collapse_end}};
}

}  // namespace sandglass

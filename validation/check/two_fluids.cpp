#include "sim/base/error.hpp"
#include "sim/scene/method/mixing.hpp"
#include "validation/check/families.hpp"
#include "validation/check/few_body_frames.hpp"
#include "validation/check/two_fluids_reference.hpp"
#include "validation/check/worst.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

// The two examples of Greenspan 1972.

namespace sandglass {

namespace {
bool is_repelling(const Scene& scene, std::uint64_t blocks, std::uint64_t core) {
  const auto* options = repulsion_in(scene);
  return options && options->support_blocks == std::vector{blocks, blocks} &&
         options->core_exponent == core && scene.species.size() == 2;
}
bool is_example_one(const Scene& scene) { return is_repelling(scene, 4, 5) && scene.given.size() == 16; }
bool is_example_two(const Scene& scene) { return is_repelling(scene, 16, 2) && particle_count(scene) == 256; }

std::size_t sample_at(const Series& series, std::uint64_t step) {
  const auto found = std::ranges::find(series.step, step);
  if (found == series.step.end())
    throw InputError(
        fmt::format("no sample of '{}' at step {}, where the reference has a point: sample more "
                    "often or run longer",
                    series.quantity.name, step));
  return static_cast<std::size_t>(found - series.step.begin());
}

/// Largest distance from the reference, over the frames that it has.
Evidence fluid_start(const Subject& subject, const law::Arguments&) {
  Evidence evidence;
  evidence.units = "length";
  for (const FluidPlaces& point : example_one_places()) {
    const auto& frames = frames_with_ids(subject);
    const auto frame = std::ranges::find(frames, point.step, &Frame::step);
    if (frame == frames.end())
      throw InputError(
          fmt::format("no frame at step {}: set output.trajectory = {{ steps = 80 }}", point.step));
    for (std::size_t i = 0; i < point.places.size(); ++i) {
      const Vector<3> apart =
          ball_in(*frame, i, 2).position - Vector<3>(point.places[i][0], point.places[i][1], 0);
      keep_worst(evidence.value, apart.norm());
    }
  }
  evidence.budget.systematic = 1e-6;
  evidence.budget.reason = "last digit of the reference";
  return evidence;
}

/// Simulated particles of a fluid, 0 the first, in the lower half of the box; bins run fastest along the height.
double in_lower_half(const Series& series, std::size_t sample, std::size_t fluid, double area) {
  const auto& shape = series.quantity.shape;
  const std::size_t rows = shape.at(1), bins = shape.at(0) * rows;
  double density = 0;
  for (std::size_t bin = 0; bin < bins; ++bin)
    if (2 * (bin % rows) + 1 < rows) density += series.value[sample * 2 * bins + 2 * bin + fluid];
  return density * area / static_cast<double>(bins);
}

/// A number for each replica.
template <class Number>
Mean over_replicas(const Subject& subject, Number number) {
  std::vector<double> numbers;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) numbers.push_back(number(replica));
  return mean_of_independent(numbers);
}

double height(const Subject& subject, std::size_t replica, std::uint64_t step, const char* fluid) {
  const std::size_t sample = sample_at(subject.series(replica, "fluid-centre"), step);
  return subject.column(replica, "fluid-centre", fluid)[sample];
}

/// Keeps the mean that is furthest from its reference in their common standard error.
class Furthest {
 public:
  void offer(const Mean& mean, const ReferenceMean& reference, const std::string& label) {
    const double error = std::hypot(mean.standard_error, reference.standard_error);
    const double ratio = std::abs(mean.value - reference.value) / error;
    ++comparisons_;
    if (!(ratio <= ratio_)) {
      ratio_ = ratio;
      evidence_ = from_mean(mean, reference.value);
      evidence_.budget.reference = reference.standard_error;
      evidence_.summary = "mean over runs against a transcription of the listing; furthest off: " + label;
    }
  }
  Evidence evidence() const {
    Evidence evidence = evidence_;
    evidence.comparisons = comparisons_;
    return evidence;
  }

 private:
  Evidence evidence_;
  double ratio_ = -1;
  int comparisons_ = 0;
};

class HeightFigure {
 public:
  HeightFigure() : figure_{"Mean height", {"step", "1", false}, {"height", "length", false}, {}, {}} {
    figure_.points = {{"heavy", {}, {}, {}, {}}, {"light", {}, {}, {}, {}}};
  }
  void add(std::size_t fluid, std::uint64_t step, const Mean& mean, const ReferenceMean& reference) {
    Figure::Points& points = figure_.points[fluid];
    points.x.push_back(static_cast<double>(step));
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
    points.expected.push_back(reference.value);
  }
  const Figure& figure() const { return figure_; }

 private:
  Figure figure_;
};

Evidence fluid_heights(const Subject& subject, const std::vector<FluidMeans>& reference) {
  Furthest furthest;
  HeightFigure figure;
  const std::uint64_t last = subject.series(0, "fluid-centre").step.back();
  for (const FluidMeans& point : reference) {
    if (point.step > last) continue;
    for (const auto& [fluid, column, expected] :
         {std::tuple{0u, "first-y", point.heavy}, std::tuple{1u, "others-y", point.light}}) {
      const Mean mean = over_replicas(subject, [&, name = column](std::size_t replica) {
        return height(subject, replica, point.step, name);
      });
      furthest.offer(mean, expected,
                     fmt::format("{} at step {}", fluid == 0 ? "heavy" : "light", point.step));
      figure.add(fluid, point.step, mean, expected);
    }
  }
  Evidence evidence = furthest.evidence();
  evidence.units = "length";
  evidence.figures.push_back(figure.figure());
  return evidence;
}

Evidence heights_one(const Subject& subject, const law::Arguments&) {
  return fluid_heights(subject, example_one_means());
}
Evidence heights_two(const Subject& subject, const law::Arguments&) {
  return fluid_heights(subject, example_two_means());
}

/// What the source saw: all four heavy particles at the bottom at step 2080, and at least three of them until the end.
Evidence outcome(const Subject& subject, const law::Arguments&) {
  const double area = subject.scene().domain.size[0] * subject.scene().domain.size[1];
  const Mean share = over_replicas(subject, [&](std::size_t replica) {
    const Series& series = subject.series(replica, "fluid-density");
    const std::size_t first = sample_at(series, 2080);
    bool stays = in_lower_half(series, first, 0, area) > 3.5;
    for (std::size_t sample = first; sample < series.step.size(); ++sample)
      stays = stays && in_lower_half(series, sample, 0, area) > 2.5;
    return stays ? 1.0 : 0.0;
  });
  Evidence evidence = from_mean(share, example_one_outcome().value);
  evidence.budget.reference = example_one_outcome().standard_error;
  evidence.summary =
      "share of starts within the printed digits after which all four heavy particles are in the lower half "
      "at "
      "step 2080 and at least three of them at every later sample";
  return evidence;
}

Evidence energies_two(const Subject& subject, const law::Arguments&) {
  Furthest furthest;
  const std::uint64_t last = subject.series(0, "energy").step.back();
  for (const FluidMeans& point : example_two_means()) {
    if (point.step > last) continue;
    const Mean mean = over_replicas(subject, [&](std::size_t replica) {
      return subject.column(replica, "energy", "")[sample_at(subject.series(replica, "energy"), point.step)];
    });
    furthest.offer(mean, point.energy, fmt::format("step {}", point.step));
  }
  Evidence evidence = furthest.evidence();
  evidence.units = "mass length^2 time^-2";
  return evidence;
}

/// A series of one replica at two steps.
Mean change(const Subject& subject, const std::function<double(std::size_t, std::uint64_t)>& value,
            std::uint64_t from, std::uint64_t to) {
  return over_replicas(subject,
                       [&](std::size_t replica) { return value(replica, to) - value(replica, from); });
}

Figure index_figure(const Subject& subject) {
  Figure figure{"Mixing index", {"step", "1", false}, {"index", "1", false}, {}, {}};
  Figure::Points points{"mean over the starts", {}, {}, {}, {}};
  const Series& first = subject.series(0, "mixing-index");
  for (std::size_t i = 0; i < first.step.size(); ++i) {
    const Mean mean = over_replicas(
        subject, [&](std::size_t replica) { return subject.series(replica, "mixing-index").value[i]; });
    points.x.push_back(static_cast<double>(first.step[i]));
    points.y.push_back(mean.value);
    points.error.push_back(mean.standard_error);
  }
  figure.points.push_back(std::move(points));
  return figure;
}

Evidence stays_mixed(const Subject& subject, const law::Arguments& numbers) {
  const Mean least = over_replicas(subject, [&](std::size_t replica) {
    const Series& series = subject.series(replica, "mixing-index");
    double sum = 0, samples = 0;
    for (std::size_t i = 0; i < series.step.size(); ++i)
      if (series.step[i] >= 69) {
        sum += series.value[i];
        samples += 1;
      }
    return sum / samples;
  });
  Evidence evidence = at_least(least, numbers.at("least"));
  evidence.summary = "mixing index, mean over the samples from step 69 on";
  evidence.figures.push_back(index_figure(subject));
  return evidence;
}

/// From step 250 to the end, as a part of the energy at step 250.
Evidence slows_down(const Subject& subject, const law::Arguments& numbers) {
  const Mean ratio = over_replicas(subject, [&](std::size_t replica) {
    const Series& series = subject.series(replica, "energy");
    return series.value.back() / series.value[sample_at(series, 250)];
  });
  Evidence evidence = from_mean(ratio, numbers.at("most"));
  evidence.kind = Expectation::at_most;
  evidence.summary = "kinetic energy at the end over that at step 250";
  return evidence;
}

/// Particles of both fluids in the upper half: at the end less at step 69.
Evidence condenses(const Subject& subject, const law::Arguments& numbers) {
  const double area = subject.scene().domain.size[0] * subject.scene().domain.size[1];
  const double all = static_cast<double>(particle_count(subject.scene()));
  const auto lower = [&](std::size_t replica, std::uint64_t step) {
    const Series& series = subject.series(replica, "fluid-density");
    const std::size_t sample = sample_at(series, step);
    return (in_lower_half(series, sample, 0, area) + in_lower_half(series, sample, 1, area)) / all;
  };
  Evidence evidence = at_least(change(subject, lower, 69, subject.series(0, "fluid-density").step.back()),
                               numbers.at("least"));
  evidence.summary = "share of all particles in the lower half, at the end less at step 69";
  return evidence;
}

CheckInfo check_of(std::string name, std::string summary, std::vector<std::string> needs,
                   bool (*applies)(const Scene&), Evidence (*evaluate)(const Subject&, const law::Arguments&),
                   std::vector<law::Parameter> numbers = {}) {
  return {std::move(name), std::move(summary), "",      std::move(needs),
          false,           std::move(numbers), applies, evaluate};
}
}  // namespace

std::vector<CheckInfo> two_fluid_checks() {
  const law::Parameter ratio{"most", "1", "largest ratio that counts as slowing down", 0, 1, 1};
  const law::Parameter share{"least", "1", "smallest share that counts as condensing", 0, 1, 0};
  const law::Parameter index{"least", "1", "smallest index that counts as mixed", 0, 1, 0.5};
  return {
      check_of("two-fluids-start",
               "places of the sixteen particles of Greenspan's example 1 less those of an independent "
               "transcription, until the printed digits decide",
               {}, is_example_one, fluid_start),
      check_of("two-fluids-heights",
               "mean heights of heavy and light particles in Greenspan's example 1 against an independent "
               "transcription",
               {"fluid-centre"}, is_example_one, heights_one),
      check_of("two-fluids-outcome",
               "how often the heavy particles of Greenspan's example 1 go to the bottom as the source saw",
               {"fluid-density"}, is_example_one, outcome),
      check_of("two-fluids-heights-256",
               "mean heights of heavy and light particles in Greenspan's example 2 against an independent "
               "transcription",
               {"fluid-centre"}, is_example_two, heights_two),
      check_of("two-fluids-energy-256",
               "kinetic energy in Greenspan's example 2 against an independent transcription", {"energy"},
               is_example_two, energies_two),
      check_of("two-fluids-stay-mixed", "mixing index of Greenspan's example 2 from step 69 on",
               {"mixing-index"}, is_example_two, stays_mixed, {index}),
      check_of("two-fluids-slow-down", "kinetic energy of Greenspan's example 2 after step 250", {"energy"},
               is_example_two, slows_down, {ratio}),
      check_of("two-fluids-condense", "particles of Greenspan's example 2 that gather in the lower half",
               {"fluid-density"}, is_example_two, condenses, {share})};
}

}  // namespace sandglass

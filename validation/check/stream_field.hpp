#pragma once

#include "validation/check/subject.hpp"
#include "validation/law/channel.hpp"

#include <array>
#include <optional>
#include <span>

namespace sandglass {

/// One species that streams in along x by an inflow at the low side and out into a vacuum at the high one.
bool is_stream(const Scene& scene);
/// A stream whose particles touch nothing across: periodic along y, and z if there is one.
bool is_free_stream(const Scene& scene);
/// A stream of spheres between two walls across y, without gravity.
bool is_channel(const Scene& scene);
/// Rough perfectly elastic particles that stream between mirrors across y, gravity pulling to the low one.
bool is_falling_stream(const Scene& scene);

/// What the bins of `fields` (and of `spin-temperature`, where particles spin) show on average from a time on, in the scales
/// of the inflow: densities, velocities and temperatures over those with which it comes in.
class StreamField {
 public:
  StreamField(const Subject& subject, double settle_time);

  using Some = std::span<const std::size_t>;
  /// Bins whose centres lie in this part of the box; `from_wall`: distances from the nearer wall across y, over half the
  /// height.
  struct Part {
    double x_low = 0, x_high = 1;  ///< over the length
    double from_wall = 0, to_wall = 1;
    std::optional<std::size_t> row = {};  ///< this bin along y alone
  };
  struct State {
    double density = 0, velocity = 0, translation = 0, rotation = 0;
    double height = 0;             ///< mean, along y
    double velocity_by_place = 0;  ///< mean over the bins, whatever they hold
    /// Mean over the degrees of freedom, three and three.
    double temperature() const { return (translation + rotation) / 2; }
  };
  State mean(Some replicas, const Part& part) const;
  /// Columns of bins along x, over the whole height or a part of it.
  std::size_t columns() const { return bins_[0]; }
  std::size_t rows() const { return bins_[1]; }
  Part column(std::size_t index, double from_wall = 0, double to_wall = 1) const;
  double place(std::size_t column) const;  ///< its middle

  std::vector<std::size_t> all() const;  ///< replicas
  bool spins() const { return spins_; }
  const Inflow& inflow() const { return subject_.scene().inflows.front(); }
  const Subject& subject() const { return subject_; }

 private:
  struct Bin {
    double density = 0, momentum = 0, weight = 0, heat = 0, turning = 0;
  };
  void read(std::size_t replica, double settle_time);
  bool holds(const Part& part, std::size_t x, std::size_t y) const;

  const Subject& subject_;
  std::array<std::size_t, 2> bins_{};
  bool spins_;
  std::vector<std::vector<Bin>> sums_;  ///< [replica][bin], over z
};

/// Mean over replicas of a function of the field, with the error of the jackknife.
template <class Value>
Mean over_replicas(const StreamField& field, Value value) {
  return jackknife(field.all().size(), [&](StreamField::Some replicas) { return value(replicas); });
}

/// The stream where it comes in, for laws.
law::CoolingStream cooling_stream_of(const Subject& subject);
law::FallingStream falling_stream_of(const Subject& subject);
/// Mean free path of the gas that comes in.
double inflow_mean_free_path(const Subject& subject);

}  // namespace sandglass

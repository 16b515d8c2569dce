#include "sim/run/sources.hpp"

#include "sim/base/error.hpp"
#include "sim/base/saved.hpp"
#include "sim/method/from_scene.hpp"
#include "sim/observe/axes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace sandglass {

namespace {
constexpr double kMostInAStep = 1e6;
constexpr int kPlaces = 100;  ///< looked at where particles have a surface

/// Edges of the region where particles appear; along the axis that it does not say, 0.
template <int D>
Vector<D> width_of(const Source& source, int axis) {
  Vector<D> width = Vector<D>::Zero();
  for (int a = 0, i = 0; a < D && !source.width.empty(); ++a)
    if (!source.height || a != axis) width[a] = source.width[static_cast<std::size_t>(i++)];
  return width;
}
}  // namespace

template <int D>
double pile_height(const View<D>& view, int axis, bool down, double speed) {
  double highest = 0;
  for (const Phase<D>& particle : view.particles) {
    const double x = particle.position[axis], v = particle.velocity[axis];
    if ((down ? -v : v) <= speed) highest = std::max(highest, down ? x : view.box[axis] - x);
  }
  return highest;
}

template <int D>
Sources<D>::Sources(const Setup<D>& setup, const Streams& streams)
    : setup_(setup),
      streams_(streams),
      room_(setup.scene),
      radius_(setup.scene.species.front().diameter / 2),
      poured_(setup.sources.size()),
      refusals_(setup.sources.size()) {
  const std::optional<std::size_t> axis = gravity_axis(setup.scene);
  for (const Source& source : setup.sources) {
    if (!source.height) continue;
    SANDGLASS_EXPECT(axis.has_value());
    axis_ = static_cast<int>(*axis);
    down_ = setup.scene.gravity[*axis] < 0;
    speed_ = falling_speed(setup.scene, source);
  }
}

template <int D>
void Sources<D>::pour(Simulator<D>& simulator, const Clock& clock) {
  std::vector<double> due_now;
  for (const Source& source : setup_.sources) due_now.push_back(due(source, clock.time));
  if (due_now == poured_) return;
  const double pile = level(simulator);
  for (std::size_t i = 0; i < due_now.size(); ++i) {
    const double count = due_now[i] - poured_[i];
    if (!(count > 0)) continue;
    if (count > kMostInAStep)
      throw RunError(
          fmt::format("step {}: a source is to pour {} particles in one step; at most {} are allowed: lower "
                      "'source.rate' or the time step",
                      clock.step, count, kMostInAStep));
    refuse_outside(setup_.sources[i], low_corner(setup_.sources[i], pile), clock);
    bring_in(simulator, i, count, pile);
  }
}

/// Hard particles one by one, for each takes room from the next. Who finds none stays due.
template <int D>
void Sources<D>::bring_in(Simulator<D>& simulator, std::size_t index, double count, double level) {
  const double at_once = room_.hard ? 1 : count;
  for (double due = count; due > 0; due -= at_once) {
    const Particles<D> particles = draw(simulator, index, at_once, level);
    if (particles.phases.empty()) {
      ++refusals_[index];
      return;
    }
    simulator.insert(particles);
    poured_[index] += at_once;
  }
}

template <int D>
std::map<std::string, double> Sources<D>::counters() const {
  const auto sum = [](const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0);
  };
  std::map<std::string, double> counters{{"particles-poured", sum(poured_)}};
  if (room_.hard) counters["sources-refused"] = sum(refusals_);
  return counters;
}

template <int D>
std::vector<double> Sources<D>::save() const {
  std::vector<double> state = poured_;
  if (room_.hard) state.insert(state.end(), refusals_.begin(), refusals_.end());
  return state;
}

template <int D>
void Sources<D>::load(const std::vector<double>& state) {
  for (std::size_t i = 0; i < poured_.size(); ++i) poured_[i] = static_cast<double>(saved_count(state.at(i)));
  if (!room_.hard) return;
  for (std::size_t i = 0; i < refusals_.size(); ++i)
    refusals_[i] = static_cast<double>(saved_count(state.at(poured_.size() + i)));
}

template <int D>
double Sources<D>::due(const Source& source, double time) const {
  const double due = std::floor(source.rate * time);
  return source.count ? std::min(due, static_cast<double>(*source.count)) : due;
}

template <int D>
double Sources<D>::level(Simulator<D>& simulator) const {
  return axis_ < 0 ? 0 : pile_height(simulator.view(), axis_, down_, speed_);
}

template <int D>
Vector<D> Sources<D>::low_corner(const Source& source, double level) const {
  const Vector<D> width = width_of<D>(source, axis_);
  Vector<D> low;
  for (int axis = 0, i = 0; axis < D; ++axis) {
    if (source.height && axis == axis_)
      low[axis] = down_ ? level + *source.height : room_.box[axis] - level - *source.height;
    else
      low[axis] = source.centre[static_cast<std::size_t>(i++)] - width[axis] / 2;
  }
  return low;
}

template <int D>
void Sources<D>::refuse_outside(const Source& source, const Vector<D>& low, const Clock& clock) const {
  const double margin = room_.margin(axis_, radius_);
  if (!source.height || (low[axis_] >= margin && low[axis_] <= room_.box[axis_] - margin)) return;
  throw RunError(
      fmt::format("step {}, time {:.6g}: a source {} above the pile stands at {} along {}, outside the box "
                  "of {}; make the box higher "
                  "('domain.size'), or lower 'source.height' or 'source.count'",
                  clock.step, clock.time, *source.height, low[axis_], axis_name(axis_), room_.box[axis_]));
}

template <int D>
std::optional<Vector<D>> Sources<D>::free_place(Simulator<D>& simulator, const Vector<D>& low,
                                                const Vector<D>& width, Random random) {
  for (int k = 0; k < kPlaces; ++k) {
    Vector<D> position;
    for (int axis = 0; axis < D; ++axis) position[axis] = low[axis] + width[axis] * random.uniform();
    if (simulator.has_room(position, 0)) return position;
  }
  return {};
}

template <int D>
Particles<D> Sources<D>::draw(Simulator<D>& simulator, std::size_t index, double count, double level) const {
  const Source& source = setup_.sources[index];
  const StreamKey key(streams_.seed, Purpose::sources, streams_.replica, index);
  const Vector<D> low = low_corner(source, level), width = width_of<D>(source, axis_);
  const auto first = static_cast<std::uint64_t>(poured_[index]);
  Particles<D> particles;
  for (std::uint64_t n = first; n < first + static_cast<std::uint64_t>(count); ++n) {
    const std::optional<Vector<D>> place = free_place(simulator, low, width, Random(key, n));
    if (!place) break;
    if (room_.blocked(*place, room_.hard ? radius_ : 0))
      throw RunError(fmt::format(
          "particle {} of a source would appear inside an obstacle; move 'source.centre' or narrow "
          "'source.width'",
          n + 1));
    particles.phases.push_back({*place, vector_of<D>(source.velocity)});
    if (setup_.weights) particles.columns.append(column::weight, setup_.weights->at(*place));
  }
  return particles;
}

template double pile_height(const View<2>&, int, bool, double);
template double pile_height(const View<3>&, int, bool, double);
template class Sources<2>;
template class Sources<3>;

}  // namespace sandglass

#include "sim/observe/collisions.hpp"

#include "sim/base/error.hpp"
#include "sim/base/saved.hpp"
#include "sim/observe/axes.hpp"
#include "sim/observe/sums.hpp"

#include <cmath>

namespace sandglass {

template <int D>
Quantity CollisionCount<D>::quantity() const {
  if (candidates_) return {"candidates", "1", "pairs tried for a collision since time zero", {}, {}, {}, ""};
  return {"collisions", "1", "collisions of simulated particles since time zero", {}, {}, {}, ""};
}

template <int D>
std::vector<double> CollisionCount<D>::measure(const View<D>& view) {
  return {static_cast<double>(candidates_ ? view.tally->candidates : view.tally->collisions)};
}

template <int D>
Quantity Pressure<D>::quantity() const {
  return {"pressure",
          D == 2 ? "mass time^-2" : "mass length^-1 time^-2",
          "pressure over the time since the previous sample",
          {3},
          {"kinetic", "collisional", "total"},
          {},
          ""};
}

template <int D>
double Pressure<D>::kinetic(const View<D>& view) const {
  return with_population(view, [&view](const auto& all) {
    return all.weight.unit * all.count * temperatures(view, all).mean() / view.box.prod();
  });
}

template <int D>
void Pressure<D>::start(const View<D>& view) {
  time_ = view.time;
  kinetic_ = kinetic(view);
  transfer_ = view.tally->transfer;
}

template <int D>
std::vector<double> Pressure<D>::measure(const View<D>& view) {
  const double interval = view.time - time_, before = kinetic_, carried = transfer_.value();
  start(view);
  // The geometric mean is the average over the interval, both of a constant and of Haff's (1 + t/t0)^-2.
  const double kinetic_part = std::sqrt(before * kinetic_);
  // With a weight column the method has counted every collision by the weights of its particles.
  const double unit = view.columns.get(column::weight).empty() ? view.weight : 1;
  const double collisional = unit * (transfer_.value() - carried) / (D * view.box.prod() * interval);
  return {kinetic_part, collisional, kinetic_part + collisional};
}

template <int D>
std::vector<double> Pressure<D>::save() const {
  std::vector<double> state = transfer_.save();
  state.push_back(time_);
  state.push_back(kinetic_);
  return state;
}

template <int D>
void Pressure<D>::load(const std::vector<double>& state) {
  transfer_ = ExactSum::load(state);
  time_ = state.at(state.size() - 2);
  kinetic_ = state.back();
}

template <int D>
Quantity ImpactParameter<D>::quantity() const {
  ObserverSpec unit;
  unit.range = {0, 1};
  unit.bins = bins_;
  return {"impact-parameter",
          "collisions",
          "collisions by impact parameter since the previous sample",
          {bins_},
          {},
          bin_edges(unit),
          "|b| / d"};
}

template <int D>
void ImpactParameter<D>::start(const View<D>& view) {
  if (view.tally->impact.size() != bins_)
    throw InputError(
        "the observer 'impact-parameter' needs a method that finds contacts; use method "
        "'event-driven' or remove the observer");
  before_ = view.tally->impact;
}

template <int D>
std::vector<double> ImpactParameter<D>::measure(const View<D>& view) {
  std::vector<double> counts(bins_);
  for (std::size_t i = 0; i < bins_; ++i)
    counts[i] = static_cast<double>(view.tally->impact.at(i) - before_[i]);
  before_ = view.tally->impact;
  return counts;
}

template <int D>
std::vector<double> ImpactParameter<D>::save() const {
  return {before_.begin(), before_.end()};
}

template <int D>
void ImpactParameter<D>::load(const std::vector<double>& state) {
  for (std::size_t i = 0; i < bins_; ++i) before_[i] = saved_count(state.at(i));
}

template <int D>
Quantity Overlap<D>::quantity() const {
  return {"overlap", "diameters", "deepest overlap at a collision since time zero", {}, {}, {}, ""};
}

template <int D>
std::vector<double> Overlap<D>::measure(const View<D>& view) {
  return {view.tally->deepest_overlap};
}

template <int D>
Quantity Crossings<D>::quantity() const {
  return {"crossings",
          "particles",
          "passages of the plane by normal velocity since the previous sample",
          {spec_.bins},
          {},
          bin_edges(spec_),
          "velocity " + axis_name(spec_.axis) + " [length/time]"};
}

template <int D>
std::vector<double> Crossings<D>::measure(const View<D>& view) {
  return view.planes->at(plane_).take_histogram();
}

template <int D>
Quantity CrossingCount<D>::quantity() const {
  return {
      "crossing-count", "particles", "passages of the plane since time zero", {2}, {"up", "down"}, {}, ""};
}

template <int D>
std::vector<double> CrossingCount<D>::measure(const View<D>& view) {
  const Plane& plane = view.planes->at(plane_);
  return {plane.up(), plane.down()};
}

template class CollisionCount<2>;
template class CollisionCount<3>;
template class Pressure<2>;
template class Pressure<3>;
template class ImpactParameter<2>;
template class ImpactParameter<3>;
template class Overlap<2>;
template class Overlap<3>;
template class Crossings<2>;
template class Crossings<3>;
template class CrossingCount<2>;
template class CrossingCount<3>;

}  // namespace sandglass

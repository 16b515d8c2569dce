#include "sim/observe/wall_force.hpp"

#include "sim/base/error.hpp"
#include "sim/observe/axes.hpp"

namespace sandglass {

template <int D>
WallForce<D>::WallForce(const ObserverSpec& spec, Kind kind) : axes_(spec.bounded), kind_(kind) {
  if (axes_.empty())
    throw InputError(
        "the observer 'wall-force' needs an axis that is not periodic; put walls there ('domain.sides') or "
        "remove the observer");
}

template <int D>
Quantity WallForce<D>::quantity() const {
  std::vector<std::string> names;
  for (const int axis : axes_)
    for (const char* side : {"-low", "-high"}) {
      if (kind_ != Kind::force) names.push_back(axis_name(axis) + side);
      if (kind_ == Kind::force)
        for (const std::string& component : axis_names(D))
          names.push_back(axis_name(axis) + side + "-" + component);
    }
  const std::size_t sides = 2 * axes_.size();
  if (kind_ == Kind::power)
    return {"wall-power",
            "mass length^2 time^-3",
            "work that each wall does on the particles, per time",
            {sides},
            names,
            {},
            ""};
  if (kind_ == Kind::heat)
    return {"wall-heat",
            "mass length^2 time^-3",
            "energy that each wall takes from the particles beside its work, per time",
            {sides},
            names,
            {},
            ""};
  return {
      "wall-force", "mass length time^-2", "force of the particles on each wall", {sides, D}, names, {}, ""};
}

template <int D>
std::vector<double> WallForce<D>::totals(const View<D>& view) const {
  std::vector<double> totals;
  for (const int axis : axes_)
    for (const bool high : {false, true}) {
      const std::size_t side = WallImpulses<D>::side(axis, high);
      const Vector<D> impulse = view.walls->impulse(side);
      if (kind_ == Kind::power) totals.push_back(view.walls->work(side));
      if (kind_ == Kind::heat) totals.push_back(view.walls->heat(side));
      if (kind_ == Kind::force) totals.insert(totals.end(), impulse.data(), impulse.data() + D);
    }
  return totals;
}

template <int D>
void WallForce<D>::start(const View<D>& view) {
  if (view.walls == nullptr)
    throw InputError("the observer 'wall-force' needs a method that counts what hits the walls; remove it");
  if (!view.columns.get(column::weight).empty())
    throw InputError(
        "the observer 'wall-force' adds up what simulated particles do, and here each stands for another "
        "number of real ones; remove it");
  time_ = view.time;
  before_ = totals(view);
}

template <int D>
std::vector<double> WallForce<D>::measure(const View<D>& view) {
  std::vector<double> values = totals(view);
  const double interval = view.time - time_;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double total = values[i];
    values[i] = view.weight * (total - before_[i]) / interval;
    before_[i] = total;
  }
  time_ = view.time;
  return values;
}

template <int D>
std::vector<double> WallForce<D>::save() const {
  std::vector<double> state = before_;
  state.push_back(time_);
  return state;
}

template <int D>
void WallForce<D>::load(const std::vector<double>& state) {
  if (state.size() != quantity().size() + 1) throw std::out_of_range("wall force");
  before_.assign(state.begin(), state.end() - 1);
  time_ = state.back();
}

template class WallForce<2>;
template class WallForce<3>;

}  // namespace sandglass

#include "sim/observe/plane.hpp"

#include "sim/base/error.hpp"
#include "sim/base/saved.hpp"

#include <algorithm>

namespace sandglass {

Plane::Plane(int axis, double position, std::vector<double> edges)
    : axis_(axis), position_(position), edges_(std::move(edges)) {
  SANDGLASS_EXPECT(edges_.size() >= 2 && std::is_sorted(edges_.begin(), edges_.end()));
  histogram_.assign(edges_.size() - 1, 0);
}

std::size_t Plane::bin(double velocity) const {
  const auto above = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, velocity);
  return static_cast<std::size_t>(above - edges_.begin()) - 1;
}

std::vector<double> Plane::take_histogram() {
  std::vector<double> counts(histogram_.begin(), histogram_.end());
  std::fill(histogram_.begin(), histogram_.end(), 0u);
  return counts;
}

void Plane::add(const Plane& other) {
  for (std::size_t i = 0; i < histogram_.size(); ++i) histogram_[i] += other.histogram_[i];
  up_ += other.up_;
  down_ += other.down_;
}

void Plane::clear() {
  std::fill(histogram_.begin(), histogram_.end(), 0u);
  up_ = down_ = 0;
}

std::vector<double> Plane::save() const {
  std::vector<double> state{up(), down()};
  state.insert(state.end(), histogram_.begin(), histogram_.end());
  return state;
}

void Plane::load(const std::vector<double>& state) {
  up_ = saved_count(state.at(0));
  down_ = saved_count(state.at(1));
  for (std::size_t i = 0; i < histogram_.size(); ++i) histogram_[i] = saved_count(state.at(i + 2));
}

}  // namespace sandglass

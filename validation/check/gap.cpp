#include "validation/check/gap.hpp"

#include "sim/scene/method/capabilities.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/shear_cell.hpp"

#include <cmath>
#include <numeric>

namespace sandglass {

namespace {
constexpr std::size_t kAcross = 1;
constexpr double kMiddle =
    0.6;  ///< of the height: what the layers at the walls do not reach at a tenth of a mean free path

double sliding(const Wall& wall) { return wall.velocity.empty() ? 0 : wall.velocity[0]; }

bool is_thermal(const Wall& wall) {
  return wall.surface.rule == SurfaceKind::thermal && wall.amplitude == 0 &&
         (wall.velocity.empty() || wall.velocity[kAcross] == 0);
}

law::Gap gap_of(const Subject& subject) {
  const Scene& scene = subject.scene();
  const Wall low = wall_at(scene, kAcross, false), high = wall_at(scene, kAcross, true);
  law::Gap gap{subject.gas((low.surface.temperature + high.surface.temperature) / 2),
               scene.domain.size[kAcross] - 2 * reach(scene), low.surface.temperature,
               high.surface.temperature, sliding(high) - sliding(low)};
  gap.gas.fraction *= scene.domain.size[kAcross] / gap.width;
  return gap;
}

double late_mean(const Subject& subject, std::size_t replica, const std::string& quantity,
                 const std::string& component, double from) {
  return mean_of_independent(late_samples(subject, replica, quantity, component, from)).value;
}
/// Along y, mean over the bins and the samples from a time on.
double energy_flux(const Subject& subject, std::size_t replica, double from) {
  const Series& series = subject.series(replica, "energy-flux");
  const auto width = static_cast<std::size_t>(subject.dimension());
  double sum = 0, count = 0;
  for (std::size_t sample = 0; sample < series.samples(); ++sample) {
    if (series.time[sample] < from) continue;
    for (std::size_t bin = 0; bin < series.quantity.size() / width; ++bin, ++count)
      sum += series.value[sample * series.quantity.size() + bin * width + kAcross];
  }
  return sum / count;
}
}  // namespace

bool is_gap(const Scene& scene) {
  if (!is_plain_gas(scene) || !capabilities(scene).collisions || !is_weightless(scene) ||
      !scene.obstacles.empty())
    return false;
  for (std::size_t axis = 0; axis < scene.domain.size.size(); ++axis)
    if (is_periodic_along(scene, axis) != (axis != kAcross)) return false;
  return is_thermal(wall_at(scene, kAcross, false)) && is_thermal(wall_at(scene, kAcross, true));
}

bool is_fourier(const Scene& scene) {
  return is_gap(scene) && is_thermal_at_rest(wall_at(scene, kAcross, false)) &&
         is_thermal_at_rest(wall_at(scene, kAcross, true)) &&
         wall_at(scene, kAcross, false).surface.temperature !=
             wall_at(scene, kAcross, true).surface.temperature;
}

bool is_couette(const Scene& scene) {
  return is_gap(scene) && sliding(wall_at(scene, kAcross, false)) != sliding(wall_at(scene, kAcross, true)) &&
         wall_at(scene, kAcross, false).surface.temperature ==
             wall_at(scene, kAcross, true).surface.temperature;
}

GapFlow::GapFlow(const Subject& subject, double settle_time)
    : subject_(subject), gap_(gap_of(subject)), box_height_(subject.scene().domain.size[kAcross]) {
  const double area = volume(subject.scene().domain) / box_height_;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Profile profile = profile_along(subject, replica, kAcross, settle_time);
    temperature_.push_back(profile.temperature);
    velocity_.push_back(momentum_along(subject, replica, settle_time));
    for (std::size_t bin = 0; bin < profile.density.size(); ++bin)
      velocity_.back()[bin] /= profile.density[bin];
    const auto force = [&](const char* component) {
      return late_mean(subject, replica, "wall-force", component, settle_time) / area;
    };
    if (subject.has("energy-flux"))
      heat_.push_back(-energy_flux(subject, replica, settle_time) * box_height_ / gap_.width);
    if (subject.has("wall-force")) stress_.push_back((force("y-low-x") - force("y-high-x")) / 2);
  }
}

std::vector<std::size_t> GapFlow::all() const {
  std::vector<std::size_t> replicas(velocity_.size());
  std::iota(replicas.begin(), replicas.end(), 0);
  return replicas;
}

double GapFlow::average(const std::vector<double>& values, Some replicas) {
  double sum = 0;
  for (const std::size_t replica : replicas) sum += values[replica];
  return sum / static_cast<double>(replicas.size());
}

double GapFlow::height(std::size_t bin) const {
  return (static_cast<double>(bin) + 0.5) / static_cast<double>(bins()) * box_height_;
}

double GapFlow::temperature_slope(Some replicas) const {
  std::vector<double> y, value;
  for (std::size_t bin = 0; bin < bins(); ++bin) {
    if (std::abs(height(bin) / box_height_ - 0.5) > kMiddle / 2) continue;
    y.push_back(height(bin) - box_height_ / 2);
    double sum = 0;
    for (const std::size_t replica : replicas) sum += temperature_[replica][bin];
    value.push_back(std::pow(sum / static_cast<double>(replicas.size()), 1.5));
  }
  return fit_line(y, value, std::vector<double>(y.size(), 1.0)).slope;
}

}  // namespace sandglass

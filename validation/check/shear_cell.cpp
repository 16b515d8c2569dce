#include "validation/check/shear_cell.hpp"

#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/check/free_flight.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass {

namespace {
constexpr std::size_t kAcross = 1;

double late_mean(const Subject& subject, std::size_t replica, const std::string& quantity,
                 const std::string& component, double from) {
  return mean_of_independent(late_samples(subject, replica, quantity, component, from)).value;
}

/// Gain of energy per time from the first to the last late sample.
double gain(const Subject& subject, std::size_t replica, double from) {
  const std::vector<double> energy = late_samples(subject, replica, "energy", "", from);
  const std::vector<double>& time = subject.series(replica, "energy").time;
  const double span = time.back() - time[time.size() - energy.size()];
  return span > 0 ? (energy.back() - energy.front()) / span : 0;
}

bool drags(const Wall& wall, double direction) {
  return wall.surface.rule == SurfaceKind::bounce_back && !wall.velocity.empty() &&
         wall.velocity[0] * direction > 0;
}
}  // namespace

std::vector<double> momentum_along(const Subject& subject, std::size_t replica, double from) {
  const Series& series = subject.series(replica, "fields");
  const std::size_t width = static_cast<std::size_t>(subject.dimension()) + 2,
                    bins = series.quantity.size() / width;
  std::vector<double> sum(bins, 0.0);
  double samples = 0;
  for (std::size_t sample = 0; sample < series.samples(); ++sample) {
    if (series.time[sample] < from) continue;
    ++samples;
    for (std::size_t bin = 0; bin < bins; ++bin) {
      const double* values = &series.value[(sample * bins + bin) * width];
      if (values[0] > 0) sum[bin] += values[0] * values[1];
    }
  }
  for (double& value : sum) value /= samples;
  return sum;
}

bool is_shear_cell(const Scene& scene) {
  return capabilities(scene).collisions && scene.species.size() == 1 && !is_rough(scene) &&
         scene.obstacles.empty() && scene.sources.empty() && is_weightless(scene) &&
         is_periodic_along(scene, 0) && !is_periodic_along(scene, kAcross) && !has_open_side(scene.domain) &&
         drags(wall_at(scene, kAcross, false), -1) && drags(wall_at(scene, kAcross, true), 1);
}

ShearCell::ShearCell(const Subject& subject, double settle_time)
    : subject_(subject), box_height_(subject.scene().domain.size[kAcross]) {
  const double area = volume(subject.scene().domain) / box_height_;
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) {
    const Profile profile = profile_along(subject, replica, kAcross, settle_time);
    density_.push_back(profile.density);
    temperature_.push_back(profile.temperature);
    momentum_.push_back(momentum_along(subject, replica, settle_time));
    const auto force = [&](const char* component) {
      return late_mean(subject, replica, "wall-force", component, settle_time) / area;
    };
    shear_.push_back((force("y-low-x") - force("y-high-x")) / 2);
    normal_.push_back((force("y-high-y") - force("y-low-y")) / 2);
    dissipated_.push_back(late_mean(subject, replica, "wall-power", "y-low", settle_time) +
                          late_mean(subject, replica, "wall-power", "y-high", settle_time) -
                          gain(subject, replica, settle_time));
  }
}

double ShearCell::average(const std::vector<double>& values, Some replicas) {
  double sum = 0;
  for (const std::size_t replica : replicas) sum += values[replica];
  return sum / static_cast<double>(replicas.size());
}

double ShearCell::height(std::size_t bin) const {
  return (static_cast<double>(bin) + 0.5) / static_cast<double>(bins()) * box_height_;
}

double ShearCell::density(Some replicas, std::size_t bin) const {
  double sum = 0;
  for (const std::size_t replica : replicas) sum += density_[replica][bin];
  return sum / static_cast<double>(replicas.size());
}

double ShearCell::velocity(Some replicas, std::size_t bin) const {
  double sum = 0;
  for (const std::size_t replica : replicas) sum += momentum_[replica][bin];
  return sum / static_cast<double>(replicas.size()) / density(replicas, bin);
}

double ShearCell::temperature(Some replicas, std::size_t bin) const {
  double sum = 0;
  for (const std::size_t replica : replicas) sum += temperature_[replica][bin];
  return sum / static_cast<double>(replicas.size());
}

ShearCell::Bulk ShearCell::bulk(Some replicas, double share) const {
  Bulk bulk;
  std::vector<double> y, u;
  for (std::size_t bin = 0; bin < bins(); ++bin) {
    if (std::abs(height(bin) / box_height_ - 0.5) > share / 2) continue;
    y.push_back(height(bin));
    u.push_back(velocity(replicas, bin));
    bulk.density += density(replicas, bin);
    bulk.temperature += temperature(replicas, bin);
  }
  bulk.density /= static_cast<double>(y.size());
  bulk.temperature /= static_cast<double>(y.size());
  bulk.rate = fit_line(y, u, std::vector<double>(y.size(), 1.0)).slope;
  return bulk;
}

double ShearCell::wall_rate() const {
  const Scene& scene = subject_.scene();
  const auto velocity = [&](bool high) { return wall_at(scene, kAcross, high).velocity[0]; };
  return (velocity(true) - velocity(false)) / (box_height_ - 2 * reach(scene));
}

law::Gas ShearCell::gas(double density, double temperature) const {
  law::Gas gas = subject_.gas(temperature);
  gas.fraction = density * law::particle_volume(gas);
  return gas;
}

}  // namespace sandglass

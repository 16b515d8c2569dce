#include "validation/check/stream_field.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/free_flight.hpp"
#include "validation/check/inertia.hpp"
#include "validation/law/contact.hpp"
#include "validation/law/enskog.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace sandglass {

bool is_stream(const Scene& scene) {
  if (scene.species.size() != 1 || scene.inflows.size() != 1 || !scene.sources.empty() ||
      !scene.obstacles.empty() || !capabilities(scene).collisions)
    return false;
  const Inflow& inflow = scene.inflows.front();
  return inflow.axis == 0 && !inflow.high && scene.domain.sides[0][1] == Side::open &&
         inflow.temperature > 0 && !inflow.velocity.empty() && inflow.velocity[0] > 0 &&
         (scene.domain.dimension == 2 || is_periodic_along(scene, 2));
}

bool is_free_stream(const Scene& scene) {
  return is_stream(scene) && is_periodic_along(scene, 1) && is_weightless(scene);
}

bool is_channel(const Scene& scene) {
  return is_stream(scene) && scene.domain.dimension == 3 &&
         scene.domain.sides[1] == std::array{Side::specular, Side::specular} && is_weightless(scene);
}

bool is_falling_stream(const Scene& scene) {
  return is_stream(scene) && scene.domain.dimension == 3 && vertical_axis(scene) == 1 &&
         scene.domain.sides[1] == std::array{Side::specular, Side::specular} &&
         is_mirror(wall_at(scene, 1, false)) && is_mirror(wall_at(scene, 1, true)) &&
         scene.species.front().restitution == 1 && scene.species.front().tangential_restitution == 1;
}

StreamField::StreamField(const Subject& subject, double settle_time)
    : subject_(subject), spins_(subject.has("spin-temperature")) {
  const std::vector<std::size_t>& shape = subject.series(0, "fields").quantity.shape;
  bins_ = {shape.at(0), shape.at(1)};
  if (subject.dimension() == 3 && shape.at(2) != 1)
    throw InputError("'fields' has several bins along z: give 1 there");
  if (spins_ && subject.series(0, "spin-temperature").quantity.size() != bins_[0] * bins_[1])
    throw InputError("'spin-temperature' has other bins than 'fields': give both the same 'grid'");
  for (std::size_t replica = 0; replica < subject.replicas(); ++replica) read(replica, settle_time);
}

void StreamField::read(std::size_t replica, double settle_time) {
  const auto width = static_cast<std::size_t>(subject_.dimension()) + 2;
  const Series& fields = subject_.series(replica, "fields");
  const Scene& scene = subject_.scene();
  const std::size_t count = bins_[0] * bins_[1];
  const double per_density = volume(scene.domain) / static_cast<double>(count) / scene.method.weight;
  std::vector<Bin>& sums = sums_.emplace_back(count);
  std::size_t samples = 0;
  for (std::size_t sample = 0; sample < fields.samples(); ++sample) {
    if (fields.time[sample] < settle_time) continue;
    ++samples;
    for (std::size_t bin = 0; bin < count; ++bin) {
      const double* values = &fields.value[(sample * count + bin) * width];
      const double weight = std::max(0.0, values[0] * per_density - 1);
      sums[bin].density += values[0];
      sums[bin].momentum += values[0] * values[1];
      sums[bin].weight += weight;
      sums[bin].heat += weight * values[width - 1];
      if (spins_)
        sums[bin].turning +=
            values[0] * subject_.series(replica, "spin-temperature").value[sample * count + bin];
    }
  }
  if (samples == 0)
    throw InputError(fmt::format(
        "no sample of 'fields' from time {} on: run longer, sample more often or lower 'settle-time'",
        settle_time));
  for (Bin& bin : sums)
    for (double* value : {&bin.density, &bin.momentum, &bin.weight, &bin.heat, &bin.turning})
      *value /= static_cast<double>(samples);
}

bool StreamField::holds(const Part& part, std::size_t x, std::size_t y) const {
  const double along = (static_cast<double>(x) + 0.5) / static_cast<double>(bins_[0]);
  const double up = (static_cast<double>(y) + 0.5) / static_cast<double>(bins_[1]);
  const double from_wall = 2 * std::min(up, 1 - up);
  return along >= part.x_low && along <= part.x_high && from_wall >= part.from_wall &&
         from_wall <= part.to_wall && (!part.row || *part.row == y);
}

StreamField::State StreamField::mean(Some replicas, const Part& part) const {
  Bin sum;
  double bins = 0, height = 0, velocity = 0;
  for (std::size_t x = 0; x < bins_[0]; ++x)
    for (std::size_t y = 0; y < bins_[1]; ++y) {
      if (!holds(part, x, y)) continue;
      double density = 0, momentum = 0;
      for (const std::size_t replica : replicas) {
        const Bin& bin = sums_[replica][x * bins_[1] + y];
        density += bin.density;
        momentum += bin.momentum;
        sum.weight += bin.weight;
        sum.heat += bin.heat;
        sum.turning += bin.turning;
      }
      sum.density += density;
      sum.momentum += momentum;
      velocity += momentum / density;
      height += density * (static_cast<double>(y) + 0.5) / static_cast<double>(bins_[1]);
      ++bins;
    }
  const Inflow& scale = inflow();
  const bool turns = spins_ && scale.spin_temperature > 0;
  return {sum.density / (bins * static_cast<double>(replicas.size())) / scale.number_density,
          sum.momentum / sum.density / scale.velocity[0],
          sum.heat / sum.weight / scale.temperature,
          turns ? sum.turning / sum.density / scale.spin_temperature : 0,
          height / sum.density * subject_.scene().domain.size[1],
          velocity / bins / scale.velocity[0]};
}

StreamField::Part StreamField::column(std::size_t index, double from_wall, double to_wall) const {
  const double width = 1 / static_cast<double>(bins_[0]), low = static_cast<double>(index) * width;
  return {low, low + width, from_wall, to_wall};
}

double StreamField::place(std::size_t column) const {
  return (static_cast<double>(column) + 0.5) / static_cast<double>(bins_[0]) *
         subject_.scene().domain.size[0];
}

std::vector<std::size_t> StreamField::all() const {
  std::vector<std::size_t> replicas(sums_.size());
  std::iota(replicas.begin(), replicas.end(), 0);
  return replicas;
}

double inflow_mean_free_path(const Subject& subject) {
  law::Gas gas = subject.gas(subject.scene().inflows.front().temperature);
  gas.fraction = subject.scene().inflows.front().number_density * law::particle_volume(gas);
  // Of points, as plain DSMC collides: no contact value.
  return law::mean_speed(gas) / (law::collision_rate(gas) / law::contact_value(3, gas.fraction));
}

law::CoolingStream cooling_stream_of(const Subject& subject) {
  const Inflow& inflow = subject.scene().inflows.front();
  const Species& species = subject.species();
  return {{3, species.restitution, species.tangential_restitution, inertia_of(species, 3)},
          species.mass,
          inflow.velocity[0],
          {inflow.temperature, inflow.spin_temperature},
          inflow_mean_free_path(subject)};
}

law::FallingStream falling_stream_of(const Subject& subject) {
  const Scene& scene = subject.scene();
  const Inflow& inflow = scene.inflows.front();
  return {subject.species().mass, inflow.temperature,   inflow.velocity[0],
          -scene.gravity[1],      scene.domain.size[1], 6};
}

}  // namespace sandglass

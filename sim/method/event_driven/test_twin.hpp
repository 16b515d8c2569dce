#pragma once

#include "sim/method/event_driven/test_gas.hpp"

namespace sandglass::event_driven {

/// The slow twin of the engine: one clock, every pair and every image looked at for every event, all particles moved.
/// Nothing but the collision rule of `sim/physics` is shared. Smooth and rough particles, species, TC model, uniform
/// gravity, specular walls, one specular obstacle.
template <int D>
class AllPairs {
 public:
  struct Happening {
    double time;
    std::uint64_t first, second;  ///< first < second; a wall: kWall + number, the obstacle: kObstacle
  };
  static constexpr std::uint64_t kWall = 1000, kObstacle = 2000;

  explicit AllPairs(const TestGas<D>& gas) : parameters_(gas.parameters), particles_(gas.particles) {
    last_.assign(particles_.phases.size(), -HUGE_VAL);
  }
  void set_obstacle(const Vector<D>& centre, double radius) { centre_ = centre, obstacle_ = radius; }

  Happening advance() {
    for (;;) {
      Happening next = look();
      const double longest = images_suffice_for();
      if (next.time > longest) {
        move(longest);
        clock_ += longest;
        continue;
      }
      perform(next);
      return {clock_, next.first, next.second};
    }
  }

 private:
  /// Only the images one box away are looked at: nobody may fly further than that.
  double images_suffice_for() const {
    double fastest = 0;
    for (const Phase<D>& phase : particles_.phases) fastest = std::max(fastest, phase.velocity.norm());
    if (parameters_.gravity.norm() > 0) return HUGE_VAL;  // dense in these tests
    return 0.25 * parameters_.geometry.box.minCoeff() / fastest;
  }

  Happening look() const {
    Happening next{HUGE_VAL, 0, 0};
    for (std::size_t i = 0; i < particles_.phases.size(); ++i) {
      look_at_fixed(i, next);
      for (std::size_t j = i + 1; j < particles_.phases.size(); ++j) look_at_pair(i, j, next);
    }
    return next;
  }

  void perform(const Happening& next) {
    move(next.time);
    clock_ += next.time;
    if (next.second >= kWall)
      bounce(next);
    else
      collide(next.first, next.second);
  }

  std::size_t kind(std::size_t i) const {
    const auto species = particles_.columns.get(column::species);
    return species.empty() ? 0 : species[i];
  }
  const SpeciesTraits& traits(std::size_t i) const { return parameters_.species[kind(i)]; }

  /// Time until |r + u t| is `reach`, from outside and approaching, by the plain formula in long numbers.
  static double meeting(const Vector<D>& r, const Vector<D>& u, double reach) {
    long double along = 0, gap = -static_cast<long double>(reach) * reach, speed = 0;
    for (int axis = 0; axis < D; ++axis) {
      along += static_cast<long double>(r[axis]) * u[axis];
      gap += static_cast<long double>(r[axis]) * r[axis];
      speed += static_cast<long double>(u[axis]) * u[axis];
    }
    if (along >= 0) return HUGE_VAL;
    if (gap <= 0) return 0;
    const long double discriminant = along * along - speed * gap;
    return discriminant < 0 ? HUGE_VAL : static_cast<double>((-along - std::sqrt(discriminant)) / speed);
  }

  void look_at_pair(std::size_t i, std::size_t j, Happening& next) const {
    const Phase<D>&a = particles_.phases[i], &b = particles_.phases[j];
    const double reach = (traits(i).diameter + traits(j).diameter) / 2;
    for (int number = 0; number < (D == 2 ? 9 : 27); ++number) {
      Vector<D> shift;
      for (int axis = 0, rest = number; axis < D; ++axis, rest /= 3)
        shift[axis] = (rest % 3 - 1) * parameters_.geometry.box[axis];
      bool allowed = true;
      for (int axis = 0; axis < D; ++axis)
        allowed &= shift[axis] == 0 || parameters_.geometry.periodic[static_cast<std::size_t>(axis)];
      if (!allowed) continue;
      const Vector<D> r = a.position - b.position - shift, u = a.velocity - b.velocity;
      if (r.norm() > reach + next.time * u.norm() + 1e-9) continue;  // too far to be the first
      const double time = meeting(r, u, reach);
      if (time < next.time) next = {time, i, j};
    }
  }

  /// Smallest time above zero at which the height x + v t + g t^2 / 2 falls to zero; at x = 0 on the way up not now.
  static double landing(long double x, long double v, long double g) {
    if (g == 0) return v < 0 ? static_cast<double>(-x / v) : HUGE_VAL;
    const long double discriminant = v * v - 2 * g * x;
    if (discriminant < 0) return HUGE_VAL;
    double first = HUGE_VAL;
    for (const int sign : {-1, 1}) {
      const long double t = (-v + sign * std::sqrt(discriminant)) / g;
      if (t > 1e-9L && v + g * t < 0) first = std::min(first, static_cast<double>(t));
    }
    return first;
  }

  void look_at_fixed(std::size_t i, Happening& next) const {
    const Phase<D>& phase = particles_.phases[i];
    const double radius = traits(i).diameter / 2;
    for (int axis = 0; axis < D; ++axis) {
      if (parameters_.geometry.periodic[static_cast<std::size_t>(axis)]) continue;
      const double x = phase.position[axis], v = phase.velocity[axis], g = parameters_.gravity[axis];
      const double low = landing(x - radius, v, g);
      const double high = landing(parameters_.geometry.box[axis] - radius - x, -v, -g);
      const auto wall = kWall + 2 * static_cast<std::uint64_t>(axis);
      if (low < next.time) next = {low, i, wall};
      if (high < next.time) next = {high, i, wall + 1};
    }
    if (obstacle_ > 0) {
      const double time = meeting(phase.position - centre_, phase.velocity, obstacle_ + radius);
      if (time < next.time) next = {time, i, kObstacle};
    }
  }

  void move(double dt) {
    for (Phase<D>& phase : particles_.phases) {
      phase.position += dt * phase.velocity + 0.5 * dt * dt * parameters_.gravity;
      phase.velocity += dt * parameters_.gravity;
      for (int axis = 0; axis < D; ++axis)
        if (parameters_.geometry.periodic[static_cast<std::size_t>(axis)])
          phase.position[axis] -= parameters_.geometry.box[axis] *
                                  std::floor(phase.position[axis] / parameters_.geometry.box[axis]);
    }
  }

  void bounce(const Happening& event) {
    Phase<D>& phase = particles_.phases[event.first];
    Vector<D> normal = Vector<D>::Unit(static_cast<int>(event.second - kWall) / 2 % D);
    if (event.second == kObstacle) normal = (phase.position - centre_).normalized();
    phase.velocity -= 2 * phase.velocity.dot(normal) * normal;
  }

  void collide(std::size_t i, std::size_t j) {
    Vector<D> normal = particles_.phases[i].position - particles_.phases[j].position;
    for (int axis = 0; axis < D; ++axis)
      if (parameters_.geometry.periodic[static_cast<std::size_t>(axis)])
        normal[axis] -=
            parameters_.geometry.box[axis] * std::nearbyint(normal[axis] / parameters_.geometry.box[axis]);
    normal.normalize();
    Surface surface = parameters_.surface(kind(i), kind(j));
    if (clock_ - std::max(last_[i], last_[j]) < parameters_.contact_time) surface.normal = {1, 0};
    last_[i] = last_[j] = clock_;
    Spin<D> none_1 = Spin<D>::Zero(), none_2 = Spin<D>::Zero();
    const auto turning = particles_.columns.edit(column::spin<D>);
    const bool spins = parameters_.rough;
    sandglass::collide<D>(surface, normal,
                          {particles_.phases[i].velocity, spins ? turning[i] : none_1, 1 / traits(i).mass,
                           spins ? 1 / traits(i).inertia : 0, traits(i).diameter / 2},
                          {particles_.phases[j].velocity, spins ? turning[j] : none_2, 1 / traits(j).mass,
                           spins ? 1 / traits(j).inertia : 0, traits(j).diameter / 2});
  }

  Parameters<D> parameters_;
  Particles<D> particles_;
  std::vector<double> last_;
  Vector<D> centre_ = Vector<D>::Zero();
  double obstacle_ = 0, clock_ = 0;
};

}  // namespace sandglass::event_driven

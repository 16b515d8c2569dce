#pragma once

#include "sim/method/event_driven/test_gas.hpp"

#include <set>

#include <gtest/gtest.h>

namespace sandglass::event_driven {

/// The slow twin of the engine: one clock, every pair and every image looked at for every event, all particles moved.
/// Nothing but the collision rule of `sim/physics` is shared. Smooth and rough particles, species, TC model, uniform
/// gravity, specular walls, obstacles, open sides and particles that come in by them.
template <int D>
class AllPairs {
 public:
  struct TwinEvent {
    double time;
    std::uint64_t first, second;  ///< first < second; kWall or kObstacle + number
  };
  static constexpr std::uint64_t kWall = 1000, kObstacle = 2000, kArrival = 3000;

  explicit AllPairs(const TestGas<D>& gas) : parameters_(gas.parameters), particles_(gas.particles) {
    last_.assign(particles_.phases.size(), -HUGE_VAL);
  }
  void add_obstacle(const Vector<D>& centre, double radius) { obstacles_.push_back({centre, radius}); }
  void open_sides(int axis) { open_[static_cast<std::size_t>(axis)] = true; }
  /// In the order of their times; smooth particles of the first species.
  void add_arrival(double time, const Phase<D>& phase) { arrivals_.push_back({time, phase}); }
  std::size_t obstacles() const { return obstacles_.size(); }

  TwinEvent advance() {
    for (;;) {
      TwinEvent next = first_event();
      const double longest = images_suffice_for();
      if (next.time > longest) {
        move(longest);
        clock_ += longest;
        continue;
      }
      perform(next);
      if (next.second == kArrival) continue;
      return {clock_, next.first, next.second};
    }
  }

 private:
  struct Obstacle {
    Vector<D> centre;
    double radius;
  };

  /// Only the images one box away are looked at: nobody may fly further than that.
  double images_suffice_for() const {
    double fastest = 0;
    for (const Phase<D>& phase : particles_.phases) fastest = std::max(fastest, phase.velocity.norm());
    if (parameters_.gravity.norm() > 0) return HUGE_VAL;  // dense in these tests
    return 0.25 * parameters_.geometry.box.minCoeff() / fastest;
  }

  TwinEvent first_event() const {
    TwinEvent next{HUGE_VAL, 0, 0};
    if (arrived_ < arrivals_.size())
      next = {std::max(0.0, arrivals_[arrived_].time - clock_), particles_.phases.size(), kArrival};
    for (std::size_t i = 0; i < particles_.phases.size(); ++i) {
      if (gone_.contains(i)) continue;
      consider_walls_and_obstacles(i, next);
      for (std::size_t j = i + 1; j < particles_.phases.size(); ++j)
        if (!gone_.contains(j)) consider_pair(i, j, next);
    }
    return next;
  }

  void perform(const TwinEvent& next) {
    move(next.time);
    clock_ += next.time;
    if (next.second == kArrival)
      arrive();
    else if (next.second >= kWall)
      bounce(next);
    else
      collide(next.first, next.second);
  }

  void arrive() {
    particles_.phases.push_back(arrivals_[arrived_++].phase);
    last_.push_back(-HUGE_VAL);
  }

  std::size_t kind(std::size_t i) const {
    const auto species = particles_.columns.get(column::species);
    return species.empty() ? 0 : species[i];
  }
  const SpeciesTraits& traits(std::size_t i) const { return parameters_.species[kind(i)]; }

  /// Time until |r + u t| is `reach`, from outside and approaching, by the plain formula in long numbers.
  static double time_to_touch(const Vector<D>& r, const Vector<D>& u, double reach) {
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

  void consider_pair(std::size_t i, std::size_t j, TwinEvent& next) const {
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
      const double time = time_to_touch(r, u, reach);
      if (time < next.time) next = {time, i, j};
    }
  }

  /// Smallest time above zero at which the height x + v t + g t^2 / 2 falls to zero; at x = 0 on the way up not now.
  static double time_to_fall(long double x, long double v, long double g) {
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

  void consider_walls_and_obstacles(std::size_t i, TwinEvent& next) const {
    const Phase<D>& phase = particles_.phases[i];
    for (int axis = 0; axis < D; ++axis) {
      const double radius = open_[static_cast<std::size_t>(axis)] ? 0 : traits(i).diameter / 2;
      if (parameters_.geometry.periodic[static_cast<std::size_t>(axis)]) continue;
      const double x = phase.position[axis], v = phase.velocity[axis], g = parameters_.gravity[axis];
      const double low = time_to_fall(x - radius, v, g);
      const double high = time_to_fall(parameters_.geometry.box[axis] - radius - x, -v, -g);
      const auto wall = kWall + 2 * static_cast<std::uint64_t>(axis);
      if (low < next.time) next = {low, i, wall};
      if (high < next.time) next = {high, i, wall + 1};
    }
    for (std::size_t k = 0; k < obstacles_.size(); ++k) {
      const double time = time_to_touch(phase.position - obstacles_[k].centre, phase.velocity,
                                        obstacles_[k].radius + traits(i).diameter / 2);
      if (time < next.time) next = {time, i, kObstacle + k};
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

  void bounce(const TwinEvent& event) {
    Phase<D>& phase = particles_.phases[event.first];
    if (event.second < kObstacle && open_[(event.second - kWall) / 2]) {
      gone_.insert(event.first);
      return;
    }
    Vector<D> normal = Vector<D>::Unit(static_cast<int>(event.second - kWall) / 2 % D);
    if (event.second >= kObstacle)
      normal = (phase.position - obstacles_[event.second - kObstacle].centre).normalized();
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
  std::vector<Obstacle> obstacles_;
  struct Arrival {
    double time;
    Phase<D> phase;
  };
  std::array<bool, D> open_{};
  std::vector<Arrival> arrivals_;
  std::size_t arrived_ = 0;
  std::set<std::size_t> gone_;
  double clock_ = 0;
};

/// The engine and its slow twin find the same pairs at the same times. Rounding grows about tenfold per collision of a
/// particle: the comparison ends before it shows. `first_obstacle`: number of the agent.
template <int D>
void expect_same_trace(const Recorder<D>& trace, AllPairs<D> twin, std::size_t count,
                       std::uint64_t first_obstacle) {
  ASSERT_GE(trace.events.size(), count);
  for (std::size_t k = 0; k < count; ++k) {
    const Event<D>& event = trace.events[k];
    const auto expected = twin.advance();
    ASSERT_NEAR(event.time, expected.time, 1e-9) << "event " << k;
    const bool agent = event.kind == Event<D>::Kind::agent;
    ASSERT_EQ(std::min(event.first, agent ? event.first : event.second), expected.first) << "event " << k;
    if (agent) {
      ASSERT_GE(expected.second, AllPairs<D>::kWall) << "event " << k;
      if (expected.second >= AllPairs<D>::kObstacle) {
        ASSERT_EQ(event.second - first_obstacle, expected.second - AllPairs<D>::kObstacle) << "event " << k;
      }
    } else {
      ASSERT_EQ(std::max(event.first, event.second), expected.second) << "event " << k;
    }
  }
}
template <int D>
void expect_same_events(const TestGas<D>& gas, const AllPairs<D>& twin, std::size_t count) {
  Recorder<D> trace;
  const auto engine = gas.make(&trace);
  for (int i = 0; trace.events.size() < count && i < 100000; ++i) engine->step(0.01, 0);
  expect_same_trace(trace, twin, count, gas.agents.size() - twin.obstacles());
}
template <int D>
void expect_same_events(const TestGas<D>& gas, std::size_t count) {
  expect_same_events(gas, AllPairs<D>(gas), count);
}

}  // namespace sandglass::event_driven

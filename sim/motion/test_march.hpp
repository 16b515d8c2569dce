#pragma once

#include "sim/motion/test_flight.hpp"

#include <functional>

namespace sandglass::motion {

/// The slow twin of the flight between surfaces with specular rules: a particle marches through the step by little
/// times; where a step leads into a surface, the time of the hit is found by bisection.
template <int D>
class March {
 public:
  March(const MotionParameters<D>& parameters, const MotionStep& step)
      : parameters_(parameters), step_(step) {
    for (int axis = 0; axis < D; ++axis)
      if (parameters.walled[static_cast<std::size_t>(axis)])
        for (const bool high : {false, true}) add_wall(axis, high);
    for (const ObstaclePlace<D>& obstacle : parameters.obstacles) add_obstacle(obstacle);
  }

  /// Passages of the unwrapped path through the plane at `position`, up less down and all.
  struct Passages {
    int up = 0, down = 0;
  };
  int hits = 0;

  Phase<D> fly(Phase<D> particle, int axis = 0, double plane = 0, Passages* passages = nullptr) {
    constexpr int kSteps = 10000;
    double time = step_.time;
    for (int i = 0; i < kSteps; ++i) {
      const double h = step_.dt / kSteps;
      const Phase<D> before = particle;
      move(particle, time, h, 0);
      time = step_.time + (i + 1) * h;
      if (passages != nullptr) {
        const double length = box<D>()[axis];
        const double passed = std::floor((particle.position[axis] - plane) / length) -
                              std::floor((before.position[axis] - plane) / length);
        (passed > 0 ? passages->up : passages->down) += std::abs(static_cast<int>(passed));
      }
    }
    return particle;
  }

 private:
  struct Surface {
    std::function<double(const Vector<D>&, double)> gap;
    std::function<Vector<D>(const Vector<D>&)> normal;
    std::function<Vector<D>(double)> velocity;
    double restitution;
  };

  void add_wall(int axis, bool high) {
    WallPlace<D> place = wall<D>(axis, high, {});
    for (const WallPlace<D>& given : parameters_.walls)
      if (given.axis == axis && given.high == high) place = given;
    const double inward = high ? -1 : 1, omega = 2 * M_PI * place.frequency;
    const auto plane = [=](double t) {
      return place.edge + place.velocity[axis] * t + place.amplitude * std::sin(omega * t);
    };
    surfaces_.push_back({[=](const Vector<D>& x, double t) { return inward * (x[axis] - plane(t)); },
                         [=](const Vector<D>&) { return Vector<D>(inward * Vector<D>::Unit(axis)); },
                         [=](double t) {
                           const double swing = place.amplitude * omega * std::cos(omega * t);
                           return Vector<D>(place.velocity + swing * Vector<D>::Unit(axis));
                         },
                         place.rule.surface.normal.value});
  }

  void add_obstacle(const ObstaclePlace<D>& obstacle) {
    const auto nearest = [=, this](const Vector<D>& x) {
      Vector<D> from = x - obstacle.centre;
      for (int axis = 0; axis < D; ++axis)
        if (!parameters_.walled[static_cast<std::size_t>(axis)])
          from[axis] -= box<D>()[axis] * std::round(from[axis] / box<D>()[axis]);
      return from;
    };
    surfaces_.push_back({[=](const Vector<D>& x, double) { return nearest(x).norm() - obstacle.radius; },
                         [=](const Vector<D>& x) { return Vector<D>(nearest(x).normalized()); },
                         [=](double) { return Vector<D>(Vector<D>::Zero()); },
                         obstacle.rule.surface.normal.value});
  }

  Phase<D> free(const Phase<D>& particle, double t) const {
    return {particle.position + t * (particle.velocity + 0.5 * t * parameters_.gravity),
            particle.velocity + t * parameters_.gravity};
  }

  void move(Phase<D>& particle, double time, double h, int depth) {
    const Phase<D> end = free(particle, h);
    for (const Surface& surface : surfaces_) {
      if (surface.gap(end.position, time + h) >= 0 || depth > 20) continue;
      double low = 0, high = h;
      while (high - low > 1e-15 * (1 + time)) {
        const double middle = 0.5 * (low + high);
        (surface.gap(free(particle, middle).position, time + middle) < 0 ? high : low) = middle;
      }
      particle = free(particle, low);
      const Vector<D> normal = surface.normal(particle.position);
      const double approach = (particle.velocity - surface.velocity(time + low)).dot(normal);
      if (approach < 0) particle.velocity -= (1 + surface.restitution) * approach * normal;
      ++hits;
      return move(particle, time + low, h - low, depth + 1);
    }
    particle = end;
  }

  MotionParameters<D> parameters_;
  MotionStep step_;
  std::vector<Surface> surfaces_;
};

}  // namespace sandglass::motion

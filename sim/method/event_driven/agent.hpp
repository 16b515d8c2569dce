#pragma once

#include "sim/base/random.hpp"
#include "sim/base/vector.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

namespace sandglass::event_driven {

/// A particle at the present moment, as an agent meets it. The agent may change it.
template <int D>
struct Guest {
  Vector<D> position, velocity;
  Spin<D>* spin = nullptr;  ///< null: smooth
  double radius = 0.5, mass = 1, inertia = 0;
  std::size_t species = 0;
  bool guarded = false;  ///< by the TC model: a dissipative contact is elastic
};

/// What an agent may do to the whole gas at an event of its own.
template <int D>
class Gathering {
 public:
  virtual ~Gathering() = default;
  virtual std::uint64_t size() const = 0;
  virtual Guest<D> guest(std::uint32_t particle) const = 0;
  /// Gives a particle another velocity, here and now.
  virtual void redirect(std::uint32_t particle, const Vector<D>& velocity) = 0;
};

/// Anything that makes events beside the particles themselves: walls, obstacles, planes that count, timers; thermostats and
/// dispensers to come. Times are those of the run.
template <int D>
class Agent {
 public:
  virtual ~Agent() = default;

  /// Whether particles with their centre in the box between two corners may meet it. Asked once per cell.
  virtual bool reaches(const Vector<D>& low, const Vector<D>& high) const {
    (void)low, (void)high;
    return false;
  }
  /// How long from now until it acts on the particle in free flight; infinity for never.
  virtual double delay(const Guest<D>& guest, double now) const {
    (void)guest, (void)now;
    return HUGE_VAL;
  }
  /// Acts on the particle that has come. True if its flight changed.
  virtual bool act(Guest<D>& guest, double now, Random& random) {
    (void)guest, (void)now, (void)random;
    return false;
  }

  /// Time of the next event of its own; infinity for none.
  virtual double next() const { return HUGE_VAL; }
  virtual void act(Gathering<D>& gathering, double now) { (void)gathering, (void)now; }

  /// What a restart needs, in as few numbers as it takes; and back.
  virtual std::vector<double> save() const { return {}; }
  virtual void load(const std::vector<double>&) {}
};

}  // namespace sandglass::event_driven

#pragma once

#include "sim/base/random.hpp"
#include "sim/method/event_driven/particle_state.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace sandglass::event_driven {

/// A box with its sides along the axes, its edges included.
template <int D>
struct Box {
  Vector<D> low, high;

  static Box everywhere() { return {Vector<D>::Constant(-HUGE_VAL), Vector<D>::Constant(HUGE_VAL)}; }
  static Box nowhere() { return {Vector<D>::Constant(HUGE_VAL), Vector<D>::Constant(-HUGE_VAL)}; }
  bool overlaps(const Box& other) const {
    return (low.array() <= other.high.array() && other.low.array() <= high.array()).all();
  }
};

/// Access to all particles, for an agent at an event of its own. They are numbered from 0; of those who have left the
/// numbers are free for a while.
template <int D>
class ParticleAccess {
 public:
  virtual ~ParticleAccess() = default;
  /// One more than the highest number.
  virtual std::uint32_t numbers() const = 0;
  virtual bool is_here(std::uint32_t particle) const = 0;
  virtual ParticleState<D> state(std::uint32_t particle) const = 0;
  /// Gives a particle another velocity, here and now.
  virtual void set_velocity(std::uint32_t particle, const Vector<D>& velocity) = 0;
  /// The same, and another species.
  virtual void convert(std::uint32_t particle, std::size_t species, const Vector<D>& velocity) = 0;
  /// Whether a particle of this species would overlap no other one there.
  virtual bool has_room(const Vector<D>& position, std::size_t species) = 0;
  /// Lets a particle in, where there is room.
  virtual void insert(const Newcomer<D>& newcomer) = 0;
  virtual void remove(std::uint32_t particle) = 0;
};

/// What an agent has made of the particle that came: nothing, another flight by a contact, another flight and species, a
/// new particle in its place, or it has left for good.
enum class Outcome { unchanged, changed, converted, replaced, gone };

/// Anything that makes events beside the particles themselves: walls, obstacles, open sides, planes that count, timers;
/// thermostats and dispensers to come. Times are those of the run.
template <int D>
class Agent {
 public:
  virtual ~Agent() = default;

  /// The box in which the centre of a particle can be when the agent acts on it.
  virtual Box<D> reach() const { return Box<D>::nowhere(); }
  /// Whether it acts on centres in a cell that overlaps that box, for shapes that do not fill their box.
  virtual bool reaches(const Box<D>& cell) const {
    (void)cell;
    return true;
  }
  /// How long from now until it acts on the particle in free flight; infinity for never.
  virtual double delay(const ParticleState<D>& particle, double now) const {
    (void)particle, (void)now;
    return HUGE_VAL;
  }
  /// Whether act() draws: only then it gets a stream, and particles keep their identities.
  virtual bool draws() const { return false; }
  /// Acts on the particle that has come.
  virtual Outcome act(ParticleState<D>& particle, double now, Random& random) {
    (void)particle, (void)now, (void)random;
    return Outcome::unchanged;
  }

  /// Time of the next event of its own; infinity for none. An agent that begins with infinity is not asked again.
  virtual double next() const { return HUGE_VAL; }
  virtual void act(ParticleAccess<D>& particles, double now) { (void)particles, (void)now; }

  /// Adds what it has counted to the counters of the record.
  virtual void count(std::map<std::string, double>& counters) const { (void)counters; }
  /// What a restart needs, in as few numbers as it takes; and back.
  virtual std::vector<double> save() const { return {}; }
  virtual void load(const std::vector<double>&) {}
};

template <int D>
using Agents = std::vector<std::unique_ptr<Agent<D>>>;

}  // namespace sandglass::event_driven

#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/method/event_driven/parameters.hpp"
#include "sim/method/simulator.hpp"

namespace sandglass::event_driven {

/// Lets in those who come by the sides of the box, each when it is due. Where the place of one is taken it takes another
/// one on its side, evenly drawn, the first of a hundred that is free; where none is, it waits for the time of a tenth of
/// its diameter at its own speed and looks again. So as many come in as are sent, with the velocities with which they are
/// sent.
template <int D>
class Entrance final : public Agent<D> {
 public:
  Entrance(const Parameters<D>& parameters, const Streams& streams);

  /// Those of a step that ends at `end`.
  void expect(const Entrants<D>& entrants, double end);
  /// Somebody has come, or will.
  bool used() const { return sent_ > 0; }

  double next() const override { return queue_.empty() ? HUGE_VAL : queue_.back().time; }
  /// Throws RunError where more wait than a stream that flows leaves behind.
  void act(ParticleAccess<D>& particles, double now) override;
  void count(std::map<std::string, double>& counters) const override;
  std::vector<double> save() const override;
  void load(const std::vector<double>& state) override;

 private:
  struct Visitor {
    double time;           ///< when it is due, or looks again
    std::uint64_t number;  ///< of all that were sent
    std::uint64_t waits;
    int axis;
    bool high;
    Newcomer<D> newcomer;
  };

  void put(const Visitor& visitor);
  bool find_place(ParticleAccess<D>& particles, Visitor& visitor);
  void let_in(ParticleAccess<D>& particles, const Visitor& visitor);
  void let_wait(Visitor visitor, double now);
  std::uint64_t waiting() const;

  Geometry<D> geometry_;
  std::vector<SpeciesTraits> species_;
  WallImpulses<D>* impulses_;
  bool loses_some_;  ///< a planted fault
  Streams streams_;
  std::vector<Visitor> queue_;  ///< the next one last
  std::uint64_t sent_ = 0, moved_ = 0, delayed_ = 0;
};

extern template class Entrance<2>;
extern template class Entrance<3>;

}  // namespace sandglass::event_driven

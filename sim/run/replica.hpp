#pragma once

#include "sim/run/collision_count.hpp"
#include "sim/run/event_trace.hpp"
#include "sim/run/inflows.hpp"
#include "sim/run/schedule.hpp"
#include "sim/run/sources.hpp"
#include "sim/run/time_step.hpp"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace sandglass {

/// One replica of a scene on its way from the initial state to the end.
template <int D>
class ReplicaRun {
 public:
  /// `state`: go on from this checkpoint; null: begin with the initial particles and the first samples. `ranks`: they share
  /// the particles; the first of them holds the samples, and save() and result() mean something there alone.
  ReplicaRun(const Setup<D>& setup, const Streams& streams, const State* state,
             Communicator* ranks = nullptr);

  bool done() const { return finished(scene_.run.duration, clock_); }
  void step();

  const Clock& clock() const { return clock_; }
  State save();
  Replica result();
  /// Frames that the scene asks for; kept for the first replica only.
  std::vector<Frame>& trajectory() { return trajectory_; }
  std::size_t bytes() const { return simulator_->bytes(); }
  std::uint64_t moves() const { return totals_.moves; }
  /// Largest share of the particles over the mean one, averaged over the steps; 1 on one rank.
  double imbalance() const { return steps_ > 0 ? imbalance_ / static_cast<double>(steps_) : 1; }
  /// Names of the series that count since time zero.
  std::set<std::string> cumulative() const;

 private:
  struct Watch {
    std::unique_ptr<Observer<D>> observer;
    Schedule schedule;
    std::optional<Cadence> start;  ///< still to come
    Series series;
  };

  /// Over all ranks.
  struct Totals {
    std::uint64_t collisions = 0, moves = 0, particles = 0;
  };

  void start();
  void count();
  void count_over_ranks();
  void take_frame();
  bool observes() const { return ranks_ == nullptr || ranks_->is_first(); }
  double time_after(double dt) const;
  void load(const State& state);
  void load(Watch& watch, const State& state);
  void refuse_other_particles(const Frame& saved);
  void refuse_broken_state(const View<D>& view) const;
  View<D> completed(View<D> view) const;
  View<D> view() { return completed(simulator_->view_of_all()); }
  View<D> view_for(const Observer<D>& observer);
  void begin(Watch& watch);
  void sample(Watch& watch);
  void sample_what_is_due();
  void refuse_standstill() const;
  std::map<std::string, double> counters();

  const Setup<D>& setup_;
  const Scene& scene_;
  Streams streams_;
  Communicator* ranks_;  ///< null: this process alone
  std::vector<Plane> planes_;
  std::unique_ptr<EventTrace<D>> trace_;       ///< of the first replica, if asked for
  std::unique_ptr<WallImpulses<D>> impulses_;  ///< if an observer needs them
  std::unique_ptr<Simulator<D>> simulator_;
  TimeStepper<D> stepper_;
  std::optional<Sources<D>> sources_;
  std::optional<Inflows<D>> inflows_;
  Clock clock_;
  CollisionCount collisions_;
  Totals totals_;
  double imbalance_ = 0;     ///< summed over the steps
  std::uint64_t steps_ = 0;  ///< of this process
  std::vector<Watch> watches_;
  std::optional<Schedule> frames_;
  std::vector<Frame> trajectory_;
};

extern template class ReplicaRun<2>;
extern template class ReplicaRun<3>;

}  // namespace sandglass

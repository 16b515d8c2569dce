#pragma once

#include "sim/method/event_driven/agent.hpp"
#include "sim/method/event_driven/era.hpp"
#include "sim/method/event_driven/event_driven.hpp"
#include "sim/method/event_driven/prefetch.hpp"
#include "sim/method/event_driven/present.hpp"
#include "sim/method/event_driven/rule.hpp"
#include "sim/method/event_driven/search.hpp"
#include "sim/method/event_driven/stall.hpp"

namespace sandglass::event_driven {

/// What the engine counts for itself.
struct Counts {
  std::uint64_t crossings = 0;    ///< of cells
  std::uint64_t predictions = 0;  ///< searches for the next collision of a particle
  std::uint64_t guarded = 0;      ///< collisions that a collapse guard made elastic
};

/// Hard disks or spheres from event to event. Each particle stands at the time of its own last change, and only the two
/// that collide move; each has one event in the calendar. Times count from the beginning of an era, so that they keep
/// their digits however long a run is.
template <int D, class Flight, bool Mixed>
class Engine final : public Simulator<D>, private Gathering<D> {
 public:
  Engine(const Parameters<D>& parameters, Agents<D> agents, const Streams& streams, EventSink<D>* trace);

  void assign(const Particles<D>& particles) override;
  void step(double dt, std::uint64_t step) override;
  View<D> view() override;
  std::span<const std::uint64_t> ids() const override { return gas_.ids; }
  std::uint64_t size() const override { return gas_.size(); }
  Tally& tally() override { return tally_; }
  std::map<std::string, double> counters() const override;
  Memory save() const override;
  void load(const Memory& memory) override;
  std::size_t bytes() const override;

 private:
  void run_until(double end);
  void handle(std::uint32_t particle);
  void cross(std::uint32_t particle);
  void collide(std::uint32_t first, std::uint32_t second);
  void meet(std::uint32_t particle, std::uint32_t agent);
  void count_impact(const Vector<D>& normal, const Vector<D>& relative);
  void tell(std::uint32_t first, std::uint32_t second, const Vector<D>& normal, double approach);
  [[noreturn]] void refuse_collapse(std::uint32_t first, std::uint32_t second) const;

  /// Looks anew for everything that may happen to a particle, and notes what comes first.
  void predict(std::uint32_t particle);
  Contact first_contact(std::uint32_t particle);
  void ask_agents(std::uint32_t particle, Contact& best) const;
  void note(std::uint32_t particle, const Contact& contact);

  void begin_era();
  void fill_cells();
  void fill_calendar();
  void scale_stall();
  void watch_cells();

  double clock() const { return origin_ + now_; }
  std::uint64_t name(std::uint32_t particle) const {
    return gas_.ids.empty() ? particle : gas_.ids[particle];
  }
  Guest<D> guest(std::uint32_t particle) const override { return guest_at(particle, now_); }
  Guest<D> guest_at(std::uint32_t particle, double time) const;
  void redirect(std::uint32_t particle, const Vector<D>& velocity) override;

  Parameters<D> parameters_;
  Flight flight_;
  Cells<D> cells_;
  ContactSearch<D, Flight, Mixed> search_;
  CollisionRule<D> rule_;
  Agents<D> agents_;
  Streams streams_;
  EventSink<D>* trace_;
  std::vector<std::uint8_t>
      watched_;  ///< by place of the cell: an agent reaches into it; empty without agents

  Gas<D> gas_;
  Era era_;
  EventCalendar calendar_;
  Prefetch<D> prefetch_;
  bool prefetches_ = false;
  Candidates near_;
  StallMonitor stall_;
  Tally tally_;
  Counts counts_;
  double now_ = 0;     ///< since the origin
  double origin_ = 0;  ///< beginning of the era, in the time of the run
  double transfer_ = 0;
  std::uint64_t events_ = 0;  ///< of this era
  std::uint64_t drawn_ = 0;   ///< random streams used by agents

  Present<D> present_;
  double seen_ = -1;  ///< time of the last view
};

}  // namespace sandglass::event_driven

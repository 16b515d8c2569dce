#pragma once

#include "sim/method/event_driven/agents_by_cell.hpp"
#include "sim/method/event_driven/entrance.hpp"
#include "sim/method/event_driven/era.hpp"
#include "sim/method/event_driven/policies.hpp"
#include "sim/method/event_driven/prefetch.hpp"
#include "sim/method/event_driven/present.hpp"
#include "sim/method/event_driven/rule.hpp"
#include "sim/method/event_driven/search.hpp"
#include "sim/method/event_driven/stall.hpp"
#include "sim/observe/event.hpp"

namespace sandglass::event_driven {

/// Hard disks or spheres from event to event. Each particle stands at the time of its own last change, and only the two
/// that collide move; each has one event in the calendar. `C` is a Choice.
template <class C>
class Engine final : public Simulator<C::D>, private ParticleAccess<C::D> {
 public:
  static constexpr int D = C::D;
  static constexpr auto kNextId = "event-driven/next-id", kEntrance = "event-driven/entrance";
  static constexpr std::uint64_t kBetweenLooks = 1 << 14;  ///< events between two looks whether to stop
  /// Collisions of a particle in a step, and how many times those of a quiet one.
  static constexpr double kMostOften = 1e4, kJam = 1000;

  Engine(const Parameters<D>& parameters, Agents<D> agents, const Streams& streams, EventSink<D>* trace);

  void assign(const Particles<D>& particles) override;
  void step(double dt, std::uint64_t step) override;
  View<D> view() override;
  std::span<const std::uint64_t> ids() const override;
  std::uint64_t size() const override { return gas_.size() - gas_.gone; }
  bool has_room(const Vector<D>& position, std::size_t species) override;
  void insert(const Particles<D>& particles) override;
  void enter(const Entrants<D>& entrants, double dt, std::uint64_t step) override;
  void remove(std::span<const std::uint32_t> places) override;
  Tally& tally() override { return tally_; }
  std::map<std::string, double> counters() const override;
  Memory save() const override;
  void load(const Memory& memory) override;
  std::size_t bytes() const override;

 private:
  void run_until(double end);
  void carry_out(std::uint32_t particle);
  void cross(std::uint32_t particle);
  void collide(std::uint32_t first, std::uint32_t second);
  void collide_with_agent(std::uint32_t particle, std::uint32_t agent);
  Outcome act(std::uint32_t agent, std::uint32_t particle, ParticleState<D>& state);
  void count_impact(const Vector<D>& normal, const Vector<D>& relative);
  void trace(std::uint32_t first, std::uint32_t second, const Vector<D>& normal, double approach);
  [[noreturn]] void refuse_collapse(std::uint32_t first, std::uint32_t second) const;

  /// Looks anew for everything that may happen to a particle, and keeps what comes first.
  void predict(std::uint32_t particle);
  Contact first_contact(std::uint32_t particle);
  void search_agents(std::uint32_t particle, Contact& best) const;
  void set_next(std::uint32_t particle, const Contact& contact);

  void let_go(std::uint32_t particle, std::uint32_t agent);
  void open_entrance();
  Memory with_entrance(Memory memory) const;
  void renew_era();
  void begin_era();
  void begin_calendar();
  void fill_calendar();
  void fill_cells();
  void scale_stall();
  /// Of a particle, since the step began.
  double collisions_of_step() const {
    return 2 * static_cast<double>(tally_.collisions - before_step_) /
           static_cast<double>(std::max({size(), size_before_step_, std::uint64_t{1}}));
  }
  void note_quiet_step();
  void refuse_jam() const;

  std::uint64_t identity(std::uint32_t particle) const {
    return gas_.ids.empty() ? particle : gas_.ids[particle];
  }
  std::uint32_t numbers() const override { return gas_.size(); }
  bool is_here(std::uint32_t particle) const override { return gas_.is_here(particle); }
  void convert(std::uint32_t particle, std::size_t species, const Vector<D>& velocity) override;
  void insert(const Newcomer<D>& newcomer) override;
  void remove(std::uint32_t particle) override;
  ParticleState<D> state(std::uint32_t particle) const override { return state_at(particle, progress_.now); }
  ParticleState<D> state_at(std::uint32_t particle, double time) const;
  void set_velocity(std::uint32_t particle, const Vector<D>& velocity) override;

  Parameters<D> parameters_;
  typename C::Conduct conduct_;
  typename C::Flight flight_;
  Cells<D> cells_;
  ContactSearch<D, typename C::Flight, C::mixed> search_;
  CollisionRule<D> rule_;
  Agents<D> agents_;
  AgentsByCell<D> agents_by_cell_;
  std::vector<Agent<D>*> timers_;  ///< agents with events of their own
  bool fills_ = false;             ///< somebody has come in, and no weight presses those who rest
  std::uint64_t before_step_ = 0;  ///< collisions
  std::uint64_t size_before_step_ = 0;
  double quietest_ = HUGE_VAL;    ///< fewest collisions of a particle in a step, with about as many of them
  std::uint64_t quiet_size_ = 0;  ///< how many there were then
  bool draws_;                    ///< an agent draws random numbers
  Streams streams_;
  EventSink<D>* trace_;
  Entrance<D> entrance_;

  Gas<D> gas_;
  std::uint64_t next_id_ = 0;  ///< of the next one that comes in
  EventCalendar calendar_;
  Prefetch<D> prefetch_;
  bool prefetches_ = false;
  Candidates near_;
  StallMonitor stall_;
  Tally tally_;
  Progress progress_;

  Present<D> present_;
  double seen_ = -1;  ///< time of the last view
};

}  // namespace sandglass::event_driven

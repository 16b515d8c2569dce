#include "sim/run/replica.hpp"

#include "sim/base/error.hpp"
#include "sim/base/saved.hpp"
#include "sim/run/check_state.hpp"
#include "sim/run/frame.hpp"
#include "sim/run/initial.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace sandglass {

namespace {
/// Goes on with a trace where the checkpoint left it: what was written after that is cut off.
template <int D>
std::unique_ptr<EventTrace<D>> make_trace(const Scene& scene, const Streams& streams, const State* state) {
  if (!scene.output.event_trace || streams.replica > 0) return nullptr;
  const std::string& path = *scene.output.event_trace;
  if (state == nullptr) return std::make_unique<EventTrace<D>>(path);
  return std::make_unique<EventTrace<D>>(path,
                                         static_cast<std::uintmax_t>(state->memory.at("event-trace").at(0)));
}
}  // namespace

template <int D>
ReplicaRun<D>::ReplicaRun(const Setup<D>& setup, const Streams& streams, const State* state,
                          Communicator* ranks)
    : setup_(setup),
      scene_(setup.scene),
      streams_(streams),
      ranks_(ranks),
      planes_(make_planes(setup.observers)),
      trace_(make_trace<D>(setup.scene, streams, state)),
      impulses_(needs_of(setup.observers).walls ? std::make_unique<WallImpulses<D>>() : nullptr),
      simulator_(setup.method->build(streams, {&planes_, trace_.get(), impulses_.get()})),
      stepper_(setup) {
  if (ranks_ != nullptr) simulator_->share(*ranks_);
  if (!setup.sources.empty()) sources_.emplace(setup, streams);
  if (!setup.inflows.empty()) inflows_.emplace(setup, streams);
  std::size_t plane = 0;
  for (std::size_t i = 0; i < setup.observers.size(); ++i) {
    for (auto& observer : make_observers<D>(setup.observers[i], plane)) {
      Quantity quantity = observer->quantity();
      watches_.push_back({std::move(observer),
                          Schedule(scene_.observe[i].cadence),
                          scene_.observe[i].start,
                          {std::move(quantity), {}, {}, {}}});
    }
    plane += needs_of(setup.observers[i]).plane ? 1 : 0;
  }
  if (scene_.output.trajectory && streams.replica == 0) frames_.emplace(*scene_.output.trajectory);
  try {
    state == nullptr ? start() : load(*state);
  } catch (const std::out_of_range&) {
    throw InputError(
        "the checkpoint lacks part of the state, as one of another version does; run its scene again");
  }
}

template <int D>
void ReplicaRun<D>::start() {
  simulator_->assign(initial_particles(setup_, streams_));
  count();
  collisions_ = {totals_.particles};
  for (Watch& watch : watches_) begin(watch);
  if (frames_) take_frame();
}

/// At time zero, where it refuses what it cannot measure, and again where its samples are to start later.
template <int D>
void ReplicaRun<D>::begin(Watch& watch) {
  if (const View<D> now = view_for(*watch.observer); observes() || watch.observer->sums_up())
    watch.observer->start(now);
  if (!watch.start && watch.observer->measures_at_start()) sample(watch);
}

template <int D>
void ReplicaRun<D>::take_frame() {
  if (const View<D> now = view(); observes()) trajectory_.push_back(frame_of(now));
}

template <int D>
void ReplicaRun<D>::count() {
  const Tally& tally = simulator_->tally();
  totals_ = {tally.collisions, tally.moves, simulator_->size()};
  if (ranks_ != nullptr) count_over_ranks();
}

template <int D>
void ReplicaRun<D>::count_over_ranks() {
  std::uint64_t largest = 0;
  Totals all;
  for (const auto& each : collect<Totals>(*ranks_, {totals_})) {
    all.collisions += each.front().collisions;
    all.moves += each.front().moves;
    all.particles += each.front().particles;
    largest = std::max(largest, each.front().particles);
  }
  totals_ = all;
  const auto mean = static_cast<double>(all.particles) / static_cast<double>(ranks_->count());
  imbalance_ += all.particles == 0 ? 1 : static_cast<double>(largest) / mean;
}

/// Steps of one length are counted, so that no rounding adds up.
template <int D>
double ReplicaRun<D>::time_after(double dt) const {
  return scene_.method.time_step.fixed ? static_cast<double>(clock_.step + 1) * dt : clock_.time + dt;
}

template <int D>
void ReplicaRun<D>::step() {
  double dt = stepper_.looks(clock_.step) ? stepper_.next(completed(simulator_->view()), clock_.step)
                                          : stepper_.current();
  if (scene_.run.duration.time) dt = std::min(dt, *scene_.run.duration.time);
  const double end = time_after(dt);
  if (inflows_) inflows_->enter(*simulator_, clock_, dt, end);
  simulator_->step(dt, clock_.step);
  ++clock_.step;
  ++steps_;
  clock_.time = end;
  count();
  clock_.collisions = collisions_.per_particle(totals_.collisions, totals_.particles);
  if (sources_) {
    sources_->pour(*simulator_, clock_);
    totals_.particles = simulator_->size();
  }
  sample_what_is_due();
  if (scene_.run.duration.collisions) refuse_standstill();
}

template <int D>
void ReplicaRun<D>::sample_what_is_due() {
  for (Watch& watch : watches_) {
    const bool due = watch.schedule.due(clock_);
    if (watch.start && reached(*watch.start, clock_)) {
      watch.start.reset();
      begin(watch);
    } else if (due && !watch.start) {
      sample(watch);
    }
  }
  if (frames_ && frames_->due(clock_)) take_frame();
}

template <int D>
void ReplicaRun<D>::refuse_standstill() const {
  const double wanted = *scene_.run.duration.collisions;
  const double poured =
      sources_ ? std::accumulate(sources_->poured().begin(), sources_->poured().end(), 0.0) : 0;
  const bool more = inflows_ ||
                    std::ranges::any_of(scene_.sources, [](const Source& source) { return !source.count; }) ||
                    poured < static_cast<double>(poured_count(scene_));
  if (totals_.particles < 2 && !more && clock_.collisions < wanted)
    throw RunError(fmt::format(
        "step {}, time {:.6g}: {} of the particles left, and the run is to last {} collisions per "
        "particle; give the duration as a time",
        clock_.step, clock_.time, totals_.particles == 0 ? "none" : "one", wanted));
  if (clock_.step % 1'000'000 == 0 && totals_.collisions == 0)
    throw RunError(
        fmt::format("no collision in {} steps, and the run is to last {} collisions per particle; raise "
                    "'method.time-step' or give the duration as a time",
                    clock_.step, wanted));
}

template <int D>
View<D> ReplicaRun<D>::completed(View<D> view) const {
  view.step = clock_.step;
  view.time = clock_.time;
  view.walls = impulses_.get();
  return view;
}

template <int D>
View<D> ReplicaRun<D>::view_for(const Observer<D>& observer) {
  if (!observer.sums_up()) return view();
  simulator_->gather_counts();
  return completed(simulator_->view());
}

template <int D>
void ReplicaRun<D>::sample(Watch& watch) {
  const View<D> now = view_for(*watch.observer);
  if (!observes() && !watch.observer->sums_up()) return;
  const std::vector<double> values = watch.observer->measure(now);
  if (values.empty() || !observes()) return;
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    throw RunError(
        fmt::format("step {}, time {:.6g}, replica {}: '{}' is not a finite number; the state is broken "
                    "(time step too long, or a force without bound?)",
                    clock_.step, clock_.time, streams_.replica, watch.series.quantity.name));
  watch.series.step.push_back(clock_.step);
  watch.series.time.push_back(clock_.time);
  watch.series.value.insert(watch.series.value.end(), values.begin(), values.end());
}

template <int D>
std::map<std::string, double> ReplicaRun<D>::counters() {
  const Tally& tally = simulator_->tally();
  std::map<std::string, double> counters = simulator_->counters();
  if (sources_) counters.merge(sources_->counters());
  if (inflows_)
    for (const auto& [name, count] : inflows_->counters()) counters[name] += count;
  counters["steps"] = static_cast<double>(clock_.step);
  counters["collisions"] = static_cast<double>(tally.collisions);
  counters["candidates"] = static_cast<double>(tally.candidates);
  counters["particle-moves"] = static_cast<double>(tally.moves);
  return counters;
}

/// The last checkpoint that can be gone on from stays.
template <int D>
void ReplicaRun<D>::refuse_broken_state(const View<D>& view) const {
  const auto whole = [](const Phase<D>& particle) {
    return particle.position.allFinite() && particle.velocity.allFinite();
  };
  if (!std::ranges::all_of(view.particles, whole))
    throw RunError(
        fmt::format("step {}, time {:.6g}, replica {}: a position or a velocity is not a finite number; the "
                    "state is broken "
                    "(time step too long, or a force without bound?)",
                    clock_.step, clock_.time, streams_.replica));
}

template <int D>
State ReplicaRun<D>::save() {
  const View<D> now = view();
  if (!observes()) return {};
  refuse_broken_state(now);
  State state{clock_.step, clock_.time, frame_of(now), {}, counters(), simulator_->save()};
  simulator_->tally().save(state.memory);
  state.memory["time-step"] = stepper_.save();
  state.memory["collisions"] = collisions_.save();
  if (sources_) state.memory["sources"] = sources_->save();
  if (inflows_) state.memory["inflows"] = inflows_->entered();
  if (trace_) state.memory["event-trace"] = {static_cast<double>(trace_->flush())};
  if (impulses_) state.memory["wall-impulses"] = impulses_->save();
  for (std::size_t i = 0; i < planes_.size(); ++i)
    state.memory[fmt::format("plane-{}", i)] = planes_[i].save();
  for (std::size_t i = 0; i < watches_.size(); ++i) {
    state.memory[fmt::format("observer-{}", i)] = watches_[i].observer->save();
    state.series.push_back(watches_[i].series);
  }
  return state;
}

template <int D>
void ReplicaRun<D>::load(const State& state) {
  require_sound(state, scene_);
  simulator_->restore(particles_of<D>(state.particles), state.memory);
  simulator_->tally().load(state.memory);
  stepper_.load(state.memory.at("time-step"));
  collisions_.load(state.memory.at("collisions"));
  if (sources_) sources_->load(state.memory.at("sources"));
  if (inflows_) inflows_->load(state.memory.at("inflows"));
  const auto known = [&](const std::string& name) { return !state.changed || state.memory.contains(name); };
  if (impulses_ && known("wall-impulses")) impulses_->load(state.memory.at("wall-impulses"));
  for (std::size_t i = 0; i < planes_.size(); ++i)
    if (const std::string name = fmt::format("plane-{}", i); known(name))
      planes_[i].load(state.memory.at(name));
  if (!observes()) simulator_->clear_counts();
  count();
  clock_ = {state.step, state.time, collisions_.per_particle(totals_.collisions, totals_.particles)};
  if (ranks_ == nullptr) refuse_other_particles(state.particles);
  for (Watch& watch : watches_) load(watch, state);
  if (frames_) frames_->resume(clock_);
}

/// What a method keeps of its particles beside the frame must be the same particles.
template <int D>
void ReplicaRun<D>::refuse_other_particles(const Frame& saved) {
  const Frame loaded = frame_of(view());
  const auto differs = [&](const NamedColumn& column) {
    const NamedColumn* known = saved.columns.find(column.info);
    return known == nullptr || known->numbers != column.numbers;
  };
  if (loaded.position != saved.position || loaded.velocity != saved.velocity ||
      std::ranges::any_of(loaded.columns.all(), differs))
    refuse_saved("particles of the method that are not those of the state");
}

/// By its name: one that was not there before begins now.
template <int D>
void ReplicaRun<D>::load(Watch& watch, const State& state) {
  watch.schedule.resume(clock_);
  if (watch.start && reached(*watch.start, clock_)) watch.start.reset();
  const Quantity& quantity = watch.series.quantity;
  const auto name = [](const Series& series) { return series.quantity.name; };
  const auto series = std::ranges::find(state.series, quantity.name, name);
  if (series == state.series.end()) {
    if (!state.changed) throw std::out_of_range(quantity.name);
    return begin(watch);
  }
  if (series->quantity.shape != quantity.shape || series->quantity.axis != quantity.axis)
    throw InputError(fmt::format(
        "the samples of '{}' in the checkpoint have other bins than the scene asks for; keep those",
        quantity.name));
  watch.observer->load(state.memory.at(fmt::format("observer-{}", series - state.series.begin())));
  watch.series = *series;
}

template <int D>
Replica ReplicaRun<D>::result() {
  if (trace_) trace_->flush();
  simulator_->gather_counts();
  Replica replica{scene_.run.seed, {}, counters()};
  for (Watch& watch : watches_) replica.series.push_back(std::move(watch.series));
  return replica;
}

template <int D>
std::set<std::string> ReplicaRun<D>::cumulative() const {
  std::set<std::string> names;
  for (const Watch& watch : watches_)
    if (watch.observer->cumulative()) names.insert(watch.series.quantity.name);
  return names;
}

template class ReplicaRun<2>;
template class ReplicaRun<3>;

}  // namespace sandglass

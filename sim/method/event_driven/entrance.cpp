#include "sim/method/event_driven/entrance.hpp"

#include "sim/base/error.hpp"
#include "sim/base/saved.hpp"
#include "sim/method/event_driven/books.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sandglass::event_driven {

namespace {
constexpr int kPlaces = 100;   ///< looked at before it waits
constexpr double kWait = 0.1;  ///< diameters of its own flight
constexpr std::uint64_t kMostWaiting = 1000;
constexpr std::uint64_t kLostOne = 20;  ///< one in so many, where the fault is planted
}  // namespace

template <int D>
Entrance<D>::Entrance(const Parameters<D>& parameters, const Streams& streams)
    : geometry_(parameters.geometry),
      species_(parameters.species),
      impulses_(parameters.impulses),
      loses_some_(parameters.faults.lost_newcomers),
      streams_(streams) {}

template <int D>
void Entrance<D>::expect(const Entrants<D>& entrants, double end) {
  const Particles<D>& sent = entrants.particles;
  const auto species = sent.columns.get(column::species);
  const auto spins = sent.columns.get(column::spin<D>);
  for (std::size_t i = 0; i < sent.phases.size(); ++i) {
    const Arrival& arrival = entrants.arrivals[i];
    Newcomer<D> newcomer{sent.phases[i].position, sent.phases[i].velocity};
    if (!species.empty()) newcomer.species = species[i];
    if (!spins.empty()) newcomer.spin = spins[i];
    queue_.push_back({end - arrival.left, sent_++, 0, arrival.axis, arrival.high, newcomer});
  }
  std::ranges::sort(queue_, [](const Visitor& a, const Visitor& b) {
    return a.time != b.time ? a.time > b.time : a.number > b.number;
  });
}

template <int D>
void Entrance<D>::act(ParticleAccess<D>& particles, double now) {
  Visitor visitor = queue_.back();
  queue_.pop_back();
  if (find_place(particles, visitor))
    let_in(particles, visitor);
  else
    let_wait(visitor, now);
}

/// Along the side; centres keep a radius from the walls beside it.
template <int D>
bool Entrance<D>::find_place(ParticleAccess<D>& particles, Visitor& visitor) {
  Newcomer<D>& newcomer = visitor.newcomer;
  if (visitor.waits == 0 && particles.has_room(newcomer.position, newcomer.species)) return true;
  Random random(StreamKey(streams_.seed, Purpose::places, streams_.replica, visitor.number), visitor.waits);
  const double radius = species_[newcomer.species].diameter / 2;
  for (int k = 0; k < kPlaces; ++k) {
    for (int axis = 0; axis < D; ++axis) {
      if (axis == visitor.axis) continue;
      const double margin = geometry_.periodic[static_cast<std::size_t>(axis)] ? 0 : radius;
      newcomer.position[axis] = margin + (geometry_.box[axis] - 2 * margin) * random.uniform();
    }
    if (!particles.has_room(newcomer.position, newcomer.species)) continue;
    ++moved_;
    return true;
  }
  return false;
}

template <int D>
void Entrance<D>::let_in(ParticleAccess<D>& particles, const Visitor& visitor) {
  note_newcomer(impulses_, WallImpulses<D>::side(visitor.axis, visitor.high),
                species_[visitor.newcomer.species], visitor.newcomer);
  if (loses_some_ && visitor.number % kLostOne == 0) return;
  particles.insert(visitor.newcomer);
}

template <int D>
void Entrance<D>::let_wait(Visitor visitor, double now) {
  const Newcomer<D>& newcomer = visitor.newcomer;
  delayed_ += visitor.waits++ == 0;
  visitor.time = now + kWait * species_[newcomer.species].diameter / newcomer.velocity.norm();
  queue_.insert(std::ranges::upper_bound(queue_, visitor.time, std::greater(), &Visitor::time), visitor);
  if (visitor.waits == 1 && waiting() > kMostWaiting)
    throw RunError(fmt::format(
        "time {:.6g}: {} particles of an [[inflow]] wait for room at their side: the stream is denser or "
        "faster than what the box takes in; lower 'inflow.number-density' or let the stream leave the box",
        now, waiting()));
}

template <int D>
std::uint64_t Entrance<D>::waiting() const {
  return static_cast<std::uint64_t>(
      std::ranges::count_if(queue_, [](const Visitor& visitor) { return visitor.waits > 0; }));
}

template <int D>
void Entrance<D>::count(std::map<std::string, double>& counters) const {
  counters["entrants-moved"] = static_cast<double>(moved_);
  counters["entrants-delayed"] = static_cast<double>(delayed_);
  counters["particles-waiting"] = static_cast<double>(queue_.size());
}

template <int D>
std::vector<double> Entrance<D>::save() const {
  const auto real = [](auto number) { return static_cast<double>(number); };
  std::vector<double> state{real(sent_), real(moved_), real(delayed_)};
  for (const Visitor& visitor : queue_) {
    const Newcomer<D>& newcomer = visitor.newcomer;
    state.insert(state.end(), {visitor.time, real(visitor.number), real(visitor.waits), real(visitor.axis),
                               real(visitor.high), real(newcomer.species)});
    const auto add = [&state](const auto& vector) {
      state.insert(state.end(), vector.data(), vector.data() + vector.size());
    };
    add(newcomer.position), add(newcomer.velocity), add(newcomer.spin);
  }
  return state;
}

template <int D>
void Entrance<D>::load(const std::vector<double>& state) {
  auto from = state.begin();
  const auto whole = [&](double most = 0x1p53) { return saved_count(*from++, "a visitor", most); };
  const auto fill = [&](auto& vector) {
    for (double& component : vector.reshaped()) component = saved_number(*from++, -1e300, 1e300, "a visitor");
  };
  constexpr std::size_t size = 6 + 2 * D + Spin<D>::SizeAtCompileTime;
  if (state.size() < 3 || (state.size() - 3) % size != 0) throw std::out_of_range("entrance");
  sent_ = whole(), moved_ = whole(), delayed_ = whole();
  queue_.clear();
  while (from != state.end()) {
    Visitor visitor{};
    visitor.time = saved_number(*from++, 0, 1e300, "a visitor");
    visitor.number = whole(), visitor.waits = whole();
    visitor.axis = static_cast<int>(whole(D - 1));
    visitor.high = whole(1) != 0;
    visitor.newcomer.species = static_cast<std::size_t>(whole(static_cast<double>(species_.size() - 1)));
    fill(visitor.newcomer.position), fill(visitor.newcomer.velocity), fill(visitor.newcomer.spin);
    queue_.push_back(visitor);
  }
}

template class Entrance<2>;
template class Entrance<3>;

}  // namespace sandglass::event_driven

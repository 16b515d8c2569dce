#include "sim/method/event_driven/gas.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::event_driven {

namespace {
template <class T>
std::size_t held(const T& column) {
  return column.capacity() * sizeof(typename T::value_type);
}

template <class T>
void permute(T& column, const std::vector<std::uint32_t>& order) {
  if (column.empty()) return;
  T sorted(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = column[order[i]];
  column.swap(sorted);
}
}  // namespace

template <int D>
void Gas<D>::assign(const Particles<D>& start, const OptionalColumns& columns) {
  kept = columns;
  gone = 0;
  const std::size_t count = start.phases.size();
  particles.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    particles[i] = {start.phases[i].position, start.phases[i].velocity, 0, 0, kNobody};
  next.assign(count, {HUGE_VAL, HUGE_VAL, kNobody, 0, 0, 0});
  spins.assign(columns.spins ? count : 0, Spin<D>::Zero());
  if (columns.spins) std::ranges::copy(start.columns.get(column::spin<D>), spins.begin());
  species.assign(columns.species ? count : 0, 0);
  if (columns.species) std::ranges::copy(start.columns.get(column::species), species.begin());
  last_contact.assign(columns.last_contact ? count : 0, -HUGE_VAL);
  ids.resize(columns.ids ? count : 0);
  const auto given = start.columns.get(column::id);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = given.empty() ? i : given[i];
}

template <int D>
void Gas<D>::append(const Newcomer<D>& newcomer, double time, std::uint64_t id) {
  particles.push_back({newcomer.position, newcomer.velocity, time, 0, kNobody});
  next.push_back({HUGE_VAL, HUGE_VAL, kNobody, 0, 0, 0});
  if (kept.spins) spins.push_back(newcomer.spin);
  if (kept.species) species.push_back(static_cast<std::uint8_t>(newcomer.species));
  if (kept.last_contact) last_contact.push_back(-HUGE_VAL);
  if (kept.ids) ids.push_back(id);
}

template <int D>
void Gas<D>::drop(std::uint32_t particle) {
  ++particles[particle].changes;
  Next& none = next[particle];
  none.time = none.contact = HUGE_VAL;
  none.partner = none.exit = kNobody;
  ++gone;
}

template <int D>
std::vector<std::uint32_t> Gas<D>::places() const {
  std::vector<std::uint32_t> places;
  places.reserve(size() - gone);
  for (std::uint32_t i = 0; i < size(); ++i)
    if (is_here(i)) places.push_back(i);
  return places;
}

/// Who expects one that has left learns of it at the time of that contact, as from a partner that has changed: its own
/// number, with changes that it never has.
template <int D>
void Gas<D>::close_ranks() {
  for (std::uint32_t i = 0; i < size(); ++i)
    if (next[i].partner < kFirstAgent && !is_here(next[i].partner)) {
      next[i].partner = i;
      next[i].partner_changes = particles[i].changes + 1;
    }
  reorder(places());
  gone = 0;
}

template <int D>
void Gas<D>::reorder(const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(particles.size());
  permute(particles, order);
  permute(next, order);
  permute(spins, order);
  permute(species, order);
  permute(last_contact, order);
  permute(ids, order);
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (Next& event : next)
    if (event.partner < kFirstAgent) event.partner = place[event.partner];
}

template <int D>
void Gas<D>::rebase(double origin) {
  for (Particle<D>& particle : particles) particle.time -= origin;
  for (Next& event : next) {
    event.time -= origin;
    event.contact -= origin;
  }
  for (double& time : last_contact) time -= origin;
}

template <int D>
std::size_t Gas<D>::bytes() const {
  return held(particles) + held(next) + held(spins) + held(species) + held(last_contact) + held(ids);
}

template struct Gas<2>;
template struct Gas<3>;

}  // namespace sandglass::event_driven

#include "sim/method/event_driven/gas.hpp"

#include <algorithm>

namespace sandglass::event_driven {

namespace {
template <class T>
std::size_t held(const T& column) {
  return column.capacity() * sizeof(typename T::value_type);
}

template <class T>
void permute(T& column, const std::vector<std::uint32_t>& order) {
  if (column.empty()) return;
  T sorted(column.size());
  for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = column[order[i]];
  column.swap(sorted);
}
}  // namespace

template <int D>
void Gas<D>::assign(const Particles<D>& particles, const Parameters<D>& parameters) {
  const std::size_t count = particles.phases.size();
  bodies.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    bodies[i] = {particles.phases[i].position, particles.phases[i].velocity, 0, 0, kNobody};
  next.assign(count, {HUGE_VAL, HUGE_VAL, kNobody, 0, 0, 0});
  spins.assign(parameters.rough ? count : 0, Spin<D>::Zero());
  if (parameters.rough) std::ranges::copy(particles.columns.get(column::spin<D>), spins.begin());
  species.assign(parameters.species.size() > 1 ? count : 0, 0);
  if (!species.empty()) std::ranges::copy(particles.columns.get(column::species), species.begin());
  last_contact.assign(parameters.contact_time > 0 ? count : 0, -HUGE_VAL);
  ids.resize(parameters.keep_ids ? count : 0);
  const auto given = particles.columns.get(column::id);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = given.empty() ? i : given[i];
}

template <int D>
void Gas<D>::reorder(const std::vector<std::uint32_t>& order) {
  permute(bodies, order);
  permute(next, order);
  permute(spins, order);
  permute(species, order);
  permute(last_contact, order);
  permute(ids, order);
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (Next& event : next)
    if (event.partner < kFirstAgent) event.partner = place[event.partner];
}

template <int D>
void Gas<D>::rebase(double origin) {
  for (Body<D>& body : bodies) body.time -= origin;
  for (Next& event : next) {
    event.time -= origin;
    event.contact -= origin;
  }
  for (double& time : last_contact) time -= origin;
}

template <int D>
std::size_t Gas<D>::bytes() const {
  return held(bodies) + held(next) + held(spins) + held(species) + held(last_contact) + held(ids);
}

template struct Gas<2>;
template struct Gas<3>;

}  // namespace sandglass::event_driven

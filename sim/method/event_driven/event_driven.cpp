#include "sim/base/error.hpp"
#include "sim/method/event_driven/check_codes.hpp"
#include "sim/method/event_driven/make_engine.hpp"

#include <fmt/format.h>

namespace sandglass::event_driven {

namespace {
template <int D, class Flight>
auto choose_mix(const Parameters<D>& parameters) {
  return parameters.species.size() > 1 ? make_engine<Choice<D, Flight, true>>
                                       : make_engine<Choice<D, Flight, false>>;
}

template <int D>
auto choose(const Parameters<D>& parameters) {
  if constexpr (D == 2)
    if (parameters.heavy && !parameters.faults.any()) return make_engine<HeavyChoice<2>>;
  if (parameters.heavy) throw InputError("this fault cannot be planted beside an [[outflow]] with a filter");
  if (parameters.faults.any()) return make_engine<FaultyChoice<D>>;
  return parameters.gravity.isZero(0) ? choose_mix<D, Straight<D>>(parameters)
                                      : choose_mix<D, Falling<D>>(parameters);
}
}  // namespace

void check_codes(std::uint64_t particles, std::uint64_t agents) {
  constexpr std::uint64_t most_particles = kFirstAgent, most_agents = kNobody - kFirstAgent;
  if (particles > most_particles)
    throw InputError(
        fmt::format("{} particles: the event-driven method takes at most {}; lower "
                    "'species.count' or take a smaller box",
                    particles, most_particles));
  if (agents > most_agents)
    throw InputError(
        fmt::format("{} walls, obstacles and planes: the event-driven method takes at most {}; remove some "
                    "obstacles",
                    agents, most_agents));
}

template <int D>
std::unique_ptr<Simulator<D>> make_event_driven(const Parameters<D>& parameters, Agents<D> agents,
                                                const Streams& streams, EventSink<D>* trace) {
  return choose(parameters)(parameters, std::move(agents), streams, trace);
}

template std::unique_ptr<Simulator<2>> make_event_driven(const Parameters<2>&, Agents<2>, const Streams&,
                                                         EventSink<2>*);
template std::unique_ptr<Simulator<3>> make_event_driven(const Parameters<3>&, Agents<3>, const Streams&,
                                                         EventSink<3>*);

}  // namespace sandglass::event_driven

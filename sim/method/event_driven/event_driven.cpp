#include "sim/method/event_driven/make_engine.hpp"

namespace sandglass::event_driven {

namespace {
template <int D, class Flight>
auto choose_mix(const Parameters<D>& parameters) {
  return parameters.species.size() > 1 ? make_engine<Choice<D, Flight, true>>
                                       : make_engine<Choice<D, Flight, false>>;
}

template <int D>
auto choose(const Parameters<D>& parameters) {
  if (parameters.faults.any()) return make_engine<FaultyChoice<D>>;
  return parameters.gravity.isZero(0) ? choose_mix<D, Straight<D>>(parameters)
                                      : choose_mix<D, Falling<D>>(parameters);
}
}  // namespace

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

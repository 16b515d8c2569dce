#include "sim/method/event_driven/engine.hpp"

#include "sim/method/event_driven/engine_events.hpp"
#include "sim/method/event_driven/engine_state.hpp"

namespace sandglass::event_driven {

namespace {
template <int D, class F>
std::unique_ptr<Simulator<D>> choose_mix(const Parameters<D>& parameters, Agents<D> agents,
                                         const Streams& streams, EventSink<D>* trace) {
  if (parameters.species.size() > 1)
    return std::make_unique<Engine<D, F, true>>(parameters, std::move(agents), streams, trace);
  return std::make_unique<Engine<D, F, false>>(parameters, std::move(agents), streams, trace);
}
}  // namespace

template <int D>
std::unique_ptr<Simulator<D>> make_event_driven(const Parameters<D>& parameters, Agents<D> agents,
                                                const Streams& streams, EventSink<D>* trace) {
  if (parameters.gravity.isZero(0))
    return choose_mix<D, Straight<D>>(parameters, std::move(agents), streams, trace);
  return choose_mix<D, Falling<D>>(parameters, std::move(agents), streams, trace);
}

template std::unique_ptr<Simulator<2>> make_event_driven(const Parameters<2>&, Agents<2>, const Streams&,
                                                         EventSink<2>*);
template std::unique_ptr<Simulator<3>> make_event_driven(const Parameters<3>&, Agents<3>, const Streams&,
                                                         EventSink<3>*);

}  // namespace sandglass::event_driven

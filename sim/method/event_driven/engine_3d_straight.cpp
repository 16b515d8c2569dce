#include "sim/method/event_driven/engine_instance.hpp"

namespace sandglass::event_driven {

template std::unique_ptr<Simulator<3>> make_engine<Choice<3, Straight<3>, false>>(const Parameters<3>&,
                                                                                  Agents<3>, const Streams&,
                                                                                  EventSink<3>*);
template std::unique_ptr<Simulator<3>> make_engine<Choice<3, Straight<3>, true>>(const Parameters<3>&,
                                                                                 Agents<3>, const Streams&,
                                                                                 EventSink<3>*);

}  // namespace sandglass::event_driven

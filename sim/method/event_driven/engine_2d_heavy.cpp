#include "sim/method/event_driven/engine_instance.hpp"

namespace sandglass::event_driven {

template std::unique_ptr<Simulator<2>> make_engine<HeavyChoice<2>>(const Parameters<2>&, Agents<2>,
                                                                   const Streams&, EventSink<2>*);

}  // namespace sandglass::event_driven

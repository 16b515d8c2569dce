#include "sim/motion/choose_flight.hpp"

namespace sandglass::motion {

template std::unique_ptr<RefusableStage<2>> make_refusable_stage(const MotionParameters<2>&,
                                                                 const Vector<2>&);

}  // namespace sandglass::motion

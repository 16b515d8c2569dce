#include "sim/motion/choose_flight.hpp"

namespace sandglass::motion {

template std::unique_ptr<RefusableStage<3>> make_refusable_stage(const MotionParameters<3>&,
                                                                 const Vector<3>&);

}  // namespace sandglass::motion

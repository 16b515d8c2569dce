#include "sim/motion/choose_flight.hpp"

namespace sandglass::motion {

template std::unique_ptr<MotionStage<2>> make_motion_stage(const MotionParameters<2>&, const Vector<2>&);

}  // namespace sandglass::motion

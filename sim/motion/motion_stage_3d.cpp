#include "sim/motion/choose_flight.hpp"

namespace sandglass::motion {

template std::unique_ptr<MotionStage<3>> make_motion_stage(const MotionParameters<3>&, const Vector<3>&);

}  // namespace sandglass::motion

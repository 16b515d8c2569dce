#include "sim/motion/choose_flight.hpp"
#include "sim/motion/entry_kernel.hpp"

namespace sandglass::motion {

template <>
std::unique_ptr<EntryStage<2>> make_entry_stage(const MotionParameters<2>& parameters, const Vector<2>& box) {
  return choose_flight(parameters, box, [&]<class Flight, bool Counts>(const auto& surroundings) {
    return std::unique_ptr<EntryStage<2>>(
        std::make_unique<EntryKernel<Flight, Counts>>(surroundings, parameters.offsets));
  });
}

}  // namespace sandglass::motion

#include "sim/method/dsmc/make_kernel.hpp"
#include "sim/method/dsmc/smooth_pairs.hpp"

namespace sandglass::dsmc {

template std::unique_ptr<CollisionStage<3>> make_kernel<3, SmoothPairs<3>>(const Parameters&);

}  // namespace sandglass::dsmc

#include "sim/method/dsmc/make_kernel.hpp"
#include "sim/method/dsmc/smooth_pairs.hpp"

namespace sandglass::dsmc {

template std::unique_ptr<CollisionStage<2>> make_kernel<2, SmoothPairs<2>>(const Parameters&);

}  // namespace sandglass::dsmc

#include "sim/method/dsmc/fitted_pairs.hpp"
#include "sim/method/dsmc/make_kernel.hpp"

namespace sandglass::dsmc {

template std::unique_ptr<CollisionStage<3>> make_kernel<3, FittedPairs<3>>(const Parameters&);

}  // namespace sandglass::dsmc

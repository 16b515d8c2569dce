#include "sim/method/dsmc/fitted_pairs.hpp"
#include "sim/method/dsmc/make_kernel.hpp"

namespace sandglass::dsmc {

template std::unique_ptr<CollisionStage<2>> make_kernel<2, FittedPairs<2>>(const Parameters&);

}  // namespace sandglass::dsmc

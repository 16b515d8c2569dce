#include "sim/method/dsmc/dense_pairs.hpp"
#include "sim/method/dsmc/make_kernel.hpp"
#include "sim/method/dsmc/rough_pairs.hpp"

namespace sandglass::dsmc {

template std::unique_ptr<CollisionStage<2>> make_kernel<2, RoughPairs<2>>(const Parameters&);
template std::unique_ptr<CollisionStage<2>> make_kernel<2, DensePairs<2, RoughPairs<2>>>(const Parameters&);

}  // namespace sandglass::dsmc

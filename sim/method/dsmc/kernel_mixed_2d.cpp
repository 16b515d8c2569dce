#include "sim/method/dsmc/dense_pairs.hpp"
#include "sim/method/dsmc/make_kernel.hpp"
#include "sim/method/dsmc/mixed_pairs.hpp"

namespace sandglass::dsmc {

template std::unique_ptr<CollisionStage<2>> make_kernel<2, MixedPairs<2>>(const Parameters&);
template std::unique_ptr<CollisionStage<2>> make_kernel<2, DensePairs<2, MixedPairs<2>>>(const Parameters&);

}  // namespace sandglass::dsmc

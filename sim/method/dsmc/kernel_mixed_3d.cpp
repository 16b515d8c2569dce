#include "sim/method/dsmc/dense_pairs.hpp"
#include "sim/method/dsmc/make_kernel.hpp"
#include "sim/method/dsmc/mixed_pairs.hpp"

namespace sandglass::dsmc {

template std::unique_ptr<CollisionStage<3>> make_kernel<3, MixedPairs<3>>(const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_kernel<3, DensePairs<3, MixedPairs<3>>>(const Parameters&);

}  // namespace sandglass::dsmc

#include "sim/method/dsmc/dense_pairs.hpp"
#include "sim/method/dsmc/faulty_pairs.hpp"
#include "sim/method/dsmc/fitted_pairs.hpp"
#include "sim/method/dsmc/make_kernel.hpp"
#include "sim/method/dsmc/mixed_pairs.hpp"
#include "sim/method/dsmc/rough_pairs.hpp"

namespace sandglass::dsmc {

template std::unique_ptr<CollisionStage<3>> make_kernel<3, FaultyPairs<3, SmoothPairs<3>>>(const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_kernel<3, FaultyPairs<3, FittedPairs<3>>>(const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_kernel<3, FaultyPairs<3, MixedPairs<3>>>(const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_kernel<3, FaultyPairs<3, DensePairs<3, MixedPairs<3>>>>(
    const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_kernel<3, FaultyPairs<3, RoughPairs<3>>>(const Parameters&);
template std::unique_ptr<CollisionStage<3>> make_kernel<3, FaultyPairs<3, DensePairs<3, RoughPairs<3>>>>(
    const Parameters&);

}  // namespace sandglass::dsmc

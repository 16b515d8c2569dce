#pragma once

#include "sim/method/builder.hpp"

namespace sandglass {

/// Every family that a run can be built from. A new one is a line here and one in sim/scene/method/families.cpp.
const std::vector<const FamilyBuilder*>& family_builders();

/// The scene's family, at work in D dimensions. Throws InputError for what the method cannot do and for a planted fault
/// that the family does not know.
template <int D>
std::unique_ptr<MethodBuilder<D>> make_builder(const BuildRequest& request);

}  // namespace sandglass

#pragma once

#include "sim/method/dsmc/parameters.hpp"
#include "sim/method/event_driven/parameters.hpp"
#include "sim/method/reservoir/reservoir.hpp"
#include "sim/run/run.hpp"

namespace sandglass {

/// Plants a fault into what a method is told. Throws InputError for a name that is not in mutations().
void plant(const Mutation& mutation, int dimension, dsmc::Parameters& parameters);
void plant(const Mutation& mutation, reservoir::Faults& faults);
void plant(const Mutation& mutation, event_driven::Parameters<2>& parameters);
void plant(const Mutation& mutation, event_driven::Parameters<3>& parameters);

}  // namespace sandglass

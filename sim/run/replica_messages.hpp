#pragma once

#include "sim/base/communicator.hpp"
#include "sim/record/record.hpp"

namespace sandglass {

/// Rank r has run the replicas r, r + ranks, ...: all of them in order, on the first rank.
std::vector<Replica> gather_replicas(Communicator& ranks, std::vector<Replica> own);

}  // namespace sandglass

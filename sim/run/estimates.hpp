#pragma once

#include "sim/record/record.hpp"

#include <set>
#include <string>
#include <vector>

namespace sandglass {

/// Mean of every series with its standard error: from the scatter of the replicas, or within a single replica from the
/// autocorrelation of its samples. Series named in `cumulative` give the rate "<name>-rate" instead.
std::vector<Estimate> estimate(const std::vector<Replica>& replicas, const std::set<std::string>& cumulative);

}  // namespace sandglass

#pragma once

#include "sim/scene/domain/domain.hpp"
#include "sim/scene/method/options.hpp"
#include "sim/scene/text/diagnostics.hpp"
#include "sim/scene/text/words.hpp"

namespace sandglass {

const Words<ContactFactor>& contact_factor_words();
const Words<DensityEstimate>& density_words();
const Words<Offset>& offset_words();
const Words<PairCount>& pair_count_words();

/// Reports cells that are too many, too wide or given in two ways.
void check_cells(const DsmcOptions& dsmc, const Domain& domain, Diagnostics& diagnostics);

}  // namespace sandglass

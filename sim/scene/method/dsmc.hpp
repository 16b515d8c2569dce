#pragma once

#include "sim/scene/domain/domain.hpp"
#include "sim/scene/method/options.hpp"
#include "sim/scene/scene.hpp"
#include "sim/scene/text/diagnostics.hpp"
#include "sim/scene/text/table.hpp"
#include "sim/scene/text/words.hpp"
#include "sim/scene/text/write_value.hpp"

namespace sandglass {

const Words<ContactFactor>& contact_factor_words();
const Words<DensityEstimate>& density_words();
const Words<Offset>& offset_words();
const Words<PairCount>& pair_count_words();
const Words<Partners>& partners_words();

// Excluded volume of cells, and the distribution of impact parameters: their keys of [method].
void read_excluded_volume(Table& table, DsmcOptions& dsmc);
void write_excluded_volume(Lines& lines, const DsmcOptions& dsmc);
void check_excluded_volume(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics);
void read_impact(Table& table, DsmcOptions& dsmc);
void write_impact(Lines& lines, const DsmcOptions& dsmc);
void check_impact(const DsmcOptions& dsmc, Diagnostics& diagnostics);

/// Reports what cannot go with several species or with spins.
void check_kinds(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics);

/// Reports what cannot go with partners at contact.
void check_partners(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics);

/// Reports what cannot go with regions of other weights.
void check_regions_of_cells(const Scene& scene, const DsmcOptions& dsmc, Diagnostics& diagnostics);

/// Reports a curve whose places do not rise, or whose lists differ in length; true when it is sound.
bool check_curve(const Curve& curve, const std::string& path, const std::string& places,
                 const std::string& values, Diagnostics& diagnostics);

// The collision cells: their keys of [method].
void read_cells(Table& table, DsmcOptions& dsmc);
void write_cells(Lines& lines, const DsmcOptions& dsmc);
/// Reports cells that are too many, too wide or given in two ways, and a lattice that the dimension does not know.
void check_cells(const DsmcOptions& dsmc, const Domain& domain, Diagnostics& diagnostics);

}  // namespace sandglass

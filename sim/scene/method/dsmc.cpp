#include "sim/scene/method/dsmc.hpp"

#include "sim/scene/method/family.hpp"
#include "sim/scene/text/bounds.hpp"

#include <fmt/format.h>

namespace sandglass {

const Words<ContactFactor>& contact_factor_words() {
  static const Words<ContactFactor> words = {{"none", ContactFactor::none}, {"local", ContactFactor::local}};
  return words;
}

const Words<DensityEstimate>& density_words() {
  static const Words<DensityEstimate> words = {{"smoothed", DensityEstimate::smoothed},
                                               {"cell", DensityEstimate::cell}};
  return words;
}

const Words<Offset>& offset_words() {
  static const Words<Offset> words = {{"none", Offset::none},
                                      {"consistent", Offset::consistent},
                                      {"corrected", Offset::corrected},
                                      {"random", Offset::random}};
  return words;
}

const Words<PairCount>& pair_count_words() {
  static const Words<PairCount> words = {{"counted", PairCount::counted},
                                         {"expected", PairCount::expected},
                                         {"time-counter", PairCount::time_counter}};
  return words;
}

namespace {
/// Length of the random offset, in diameters, of a scene that asks for one without saying how long.
constexpr double default_random_offset = 0.5;
constexpr double least_corrected =
    0.1;  // the corrected offset is d (1 + r) / (2 r): 5.5 d here, no bound below
constexpr std::uint64_t most_across = 9999;  // cells of a density window

void read_random_offset(Table& table, DsmcOptions& dsmc) {
  if (dsmc.offset == Offset::random) {
    dsmc.random_offset = default_random_offset;
    table.read("random-offset", dsmc.random_offset);
  } else if (!table.clean("offset")) {
    table.skip("random-offset");
  } else {
    table.refuse("random-offset", "is used with offset = \"random\" only; the offset here is \"" +
                                      word_of(offset_words(), dsmc.offset) + '"');
  }
}

void read(Table& table, MethodOptions& options) {
  DsmcOptions& dsmc = std::get<DsmcOptions>(options);
  table.read_word("contact-factor", "contact factor", dsmc.contact_factor, contact_factor_words());
  table.read_word("density", "density estimate", dsmc.density, density_words());
  table.read("density-window", dsmc.density_window);
  table.read_word("offset", "offset", dsmc.offset, offset_words());
  read_random_offset(table, dsmc);
  table.read_word("pair-count", "pair count", dsmc.pair_count, pair_count_words());
  table.read_word("partners", "choice of partners", dsmc.partners, partners_words());
  read_excluded_volume(table, dsmc);
  read_impact(table, dsmc);
  read_cells(table, dsmc);
}

void write(Lines& lines, const MethodOptions& options) {
  const DsmcOptions& dsmc = std::get<DsmcOptions>(options);
  lines.add("contact-factor", word_of(contact_factor_words(), dsmc.contact_factor));
  lines.add("density", word_of(density_words(), dsmc.density));
  lines.add("density-window", dsmc.density_window);
  lines.add("offset", word_of(offset_words(), dsmc.offset));
  if (dsmc.offset == Offset::random) lines.add("random-offset", dsmc.random_offset);
  lines.add("pair-count", word_of(pair_count_words(), dsmc.pair_count));
  lines.add("partners", word_of(partners_words(), dsmc.partners));
  write_excluded_volume(lines, dsmc);
  write_impact(lines, dsmc);
  write_cells(lines, dsmc);
}

void check_corrected_offset(const Scene& scene, Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < scene.species.size(); ++i) {
    const double restitution = scene.species[i].restitution;
    if (!(restitution >= 0 && restitution < least_corrected)) continue;
    const std::string path = item_path("species", i) + ".restitution";
    diagnostics.report(
        path, fmt::format("{} is {}; with offset = \"corrected\" at least {} is allowed, since the offset "
                          "d (1 + r) / (2 r) has no bound as r goes to 0",
                          shown(path), restitution, least_corrected));
  }
}

void check_time_counter(const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  if (dsmc.pair_count != PairCount::time_counter || dsmc.lattice != CellLattice::shifted) return;
  diagnostics.report(
      "method.pair-count",
      "'method.pair-count' must not be \"time-counter\" with lattice = \"shifted\": a clock is "
      "that of particles which stay in its cell for some steps");
}

void check_density_window(const DsmcOptions& dsmc, Diagnostics& diagnostics) {
  if (!dsmc.density_window || !diagnostics.clean("method.density-window")) return;
  if (dsmc.contact_factor == ContactFactor::none || dsmc.density != DensityEstimate::smoothed)
    return diagnostics.report("method.density-window",
                              "'method.density-window' is used with contact-factor = \"local\" and density = "
                              "\"smoothed\" only; remove it");
  if (*dsmc.density_window % 2 == 0 || *dsmc.density_window > most_across)
    diagnostics.report(
        "method.density-window",
        fmt::format("'method.density-window' is {}; allowed: an odd number of cells, 1 to {}: as many to "
                    "each side of a cell, and the cell",
                    *dsmc.density_window, most_across));
}

void check(const Scene& scene, Diagnostics& diagnostics) {
  const DsmcOptions& dsmc = std::get<DsmcOptions>(scene.method.options);
  if (dsmc.density != DensityEstimate::smoothed && dsmc.contact_factor == ContactFactor::none)
    diagnostics.report("method.density", "'method.density' is used with contact-factor = \"local\" only");
  check_density_window(dsmc, diagnostics);
  check_bounds(diagnostics, "method.random-offset", dsmc.random_offset, between(0, 10));
  if (dsmc.random_offset != 0 && dsmc.offset != Offset::random)
    diagnostics.report("method.random-offset",
                       "'method.random-offset' is used with offset = \"random\" only");
  if (dsmc.offset == Offset::corrected) check_corrected_offset(scene, diagnostics);
  if (dsmc.cell_size) check_bounds(diagnostics, "method.cell-size", *dsmc.cell_size, moderate());
  check_excluded_volume(scene, dsmc, diagnostics);
  check_impact(dsmc, diagnostics);
  check_cells(dsmc, scene.domain, diagnostics);
  if (!(scene.sources.empty() && scene.inflows.empty()) && dsmc.cells.empty() && !dsmc.cell_size)
    diagnostics.report("method",
                       "with a [[source]] or an [[inflow]] the number of particles changes, and the cells "
                       "cannot follow from that at "
                       "the start: give 'method.cells' or 'method.cell-size'");
  check_time_counter(dsmc, diagnostics);
  check_partners(scene, dsmc, diagnostics);
  check_kinds(scene, dsmc, diagnostics);
  check_regions_of_cells(scene, dsmc, diagnostics);
}

Preset preset(const char* name, const char* summary, ContactFactor factor, Offset offset,
              PairCount pair_count = PairCount::counted) {
  DsmcOptions options;
  options.pair_count = pair_count;
  options.contact_factor = factor;
  options.offset = offset;
  return {{name, summary}, options};
}

struct HybridChoices {
  Entry entry = Entry::free;
  ImpactDistribution impact = ImpactDistribution::uniform;
  bool offset_in_full_cells = false;
  CellLattice lattice = CellLattice::fixed;
};

/// Hybrid simulation Monte Carlo: `cba` with an excluded volume of cells.
Preset hybrid(const char* name, const char* summary, const HybridChoices& choices = {}) {
  DsmcOptions options;
  options.contact_factor = ContactFactor::local;
  options.offset = Offset::consistent;
  options.excluded_volume = ExcludedVolume::cells;
  options.entry = choices.entry;
  options.impact = choices.impact;
  options.offset_in_full_cells = choices.offset_in_full_cells;
  options.lattice = choices.lattice;
  return {{name, summary}, options};
}

Preset at_contact(const char* name, const char* summary) {
  DsmcOptions options;
  options.contact_factor = ContactFactor::local;
  options.partners = Partners::contact;
  return {{name, summary}, options};
}

Preset fitted(const char* name, const char* summary) {
  DsmcOptions options;
  options.impact = ImpactDistribution::fitted;
  return {{name, summary}, options};
}

MethodFamily make_family() {
  using enum SurfaceKind;
  MethodFamily family;
  family.name = "dsmc";
  family.can.weights = true;
  family.can.regions = true;
  family.can.species = true;
  family.can.spins = true;
  family.can.cells = true;
  family.can.ranks = true;
  family.can.wall_rules = {specular, bounce_back, random_tangential_sign, thermal};
  family.can.obstacles = true;
  family.can.varying_number = true;
  family.presets = {
      preset("dsmc", "dilute gas: point-like collisions inside a cell", ContactFactor::none, Offset::none),
      preset("dsmc-bird", "dsmc by time counter: pairs of a cell collide until its clock has passed the step",
             ContactFactor::none, Offset::none, PairCount::time_counter),
      preset("dsmc-enskog", "collision rate raised by the contact value of the local density, no offset",
             ContactFactor::local, Offset::none),
      preset("cba",
             "consistent Boltzmann algorithm: contact value, and each partner displaced by one diameter",
             ContactFactor::local, Offset::consistent),
      preset("cba-corrected",
             "cba with the displacement that gives the hard-core virial for restitution below one",
             ContactFactor::local, Offset::corrected),
      preset("cuba", "cba with a further random displacement of zero mean that tunes transport",
             ContactFactor::local, Offset::random),
      preset(
          "cba-expected-pairs",
          "cba that takes its candidates from the pairs expected by chance: right with few particles a cell",
          ContactFactor::local, Offset::consistent, PairCount::expected),
      at_contact("esmc",
                 "Enskog simulation Monte Carlo: partners a diameter away, contact value at the midpoint"),
      hybrid("hsmc",
             "hybrid simulation Monte Carlo: cba, and cells take in no more than the densest packing"),
      hybrid("hsmc-ramp", "hsmc where a cell is the harder to enter the fuller it is",
             {.entry = Entry::falling}),
      hybrid("hsmc-pb", "hsmc with impact parameters from p(b) = a/(1 - c b^2)",
             {.impact = ImpactDistribution::fitted}),
      hybrid("hsmc-offset-everywhere", "hsmc that displaces partners in full cells too: heaps do not rest",
             {.offset_in_full_cells = true}),
      hybrid("hsmc-shift", "hsmc whose cells are displaced at random every step",
             {.lattice = CellLattice::shifted}),
      hybrid("hsmc-rotated", "hsmc with square cells that stand on a corner, in 2D",
             {.lattice = CellLattice::diagonal}),
      fitted("dsmc-pb", "dsmc with impact parameters from p(b) = a/(1 - c b^2)")};
  family.keys = {"contact-factor",
                 "density",
                 "density-window",
                 "offset",
                 "random-offset",
                 "pair-count",
                 "partners",
                 "excluded-volume",
                 "densest-fraction",
                 "entry",
                 "entry-probability",
                 "offset-in-full-cells",
                 "impact",
                 "impact-coefficient",
                 "lattice",
                 "cells",
                 "cell-size"};
  family.read = read;
  family.write = write;
  family.check = check;
  return family;
}
}  // namespace

const MethodFamily& dsmc_family() {
  static const MethodFamily family = make_family();
  return family;
}

}  // namespace sandglass

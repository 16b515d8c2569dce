#include "sim/method/dsmc/family.hpp"

#include "sim/base/error.hpp"
#include "sim/base/packing.hpp"
#include "sim/method/boundary_faults.hpp"
#include "sim/method/collision_rate.hpp"
#include "sim/method/dsmc/dsmc.hpp"
#include "sim/method/dsmc/from_scene.hpp"
#include "sim/method/dsmc/local_factor.hpp"
#include "sim/method/dsmc/pair_deficit.hpp"
#include "sim/method/dsmc/planted_faults.hpp"
#include "sim/method/motion_from_scene.hpp"
#include "sim/method/region_weights.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass::dsmc {

namespace {

template <int D>
class Builder final : public MethodBuilder<D> {
 public:
  explicit Builder(const BuildRequest& request)
      : scene_(request.scene),
        parameters_(parameters_of<D>(scene_)),
        cells_(cells_of<D>(scene_, default_particles_per_cell(D, parameters_, density()))),
        motion_(motion_of<D>(with_scene_fault(scene_, request.fault))) {
    if (!scene_.regions.empty()) {
      const RegionWeights<D> weights(scene_, cells_.grid());
      parameters_.weights.assign(weights.of_cells().begin(), weights.of_cells().end());
    }
    plant(planted_faults(), request.fault, parameters_, D);
    if (parameters_.partners == Partners::contact && parameters_.faults.any())
      throw InputError(
          "the planted fault is one of collisions within a cell; with partners = \"contact\" plant "
          "another, such as 'partners-at-half-the-distance'");
    parameters_.measure_transfer = request.needs.transfer;
    parameters_.count_by_species = request.needs.by_species;
    motion_.offsets = parameters_.offset.any();
  }

  double collision_rate(double temperature) const override {
    if (parameters_.kinds.mixed())
      return parameters_.factor.formula == nullptr ? rate_of_points(scene_, temperature)
                                                   : enskog_rate(scene_, temperature);
    const Species& species = scene_.species.front();
    const double contact =
        parameters_.factor.formula == nullptr ? 1 : parameters_.factor.formula(fraction(scene_)).value;
    return M_SQRT2 * density() * parameters_.cross_section * contact *
           mean_speed(D, std::sqrt(temperature / species.mass));
  }

  double cell_edge() const override { return cells_.width(); }

  std::unique_ptr<Simulator<D>> build(const Streams& streams,
                                      const Attachments<D>& attachments) const override {
    motion::MotionParameters<D> motion = motion_;
    motion.planes = attachments.planes;
    motion.impulses = attachments.impulses;
    return std::make_unique<Dsmc<D>>(cells_, parameters_, motion, streams, Purpose::collisions,
                                     columns(parameters_.kinds, scene_.output.ids));
  }

  std::unique_ptr<Simulator<D>> build_elastic(const Streams& streams) const override {
    Parameters elastic = parameters_;
    elastic.restitution = 1;
    elastic.measure_transfer = false;
    elastic.count_by_species = false;
    elastic.kinds.rough = false;
    elastic.kinds.surfaces.assign(elastic.kinds.surfaces.size(), Surface{});
    // Ids lead back to the species and spins of the start.
    return std::make_unique<Dsmc<D>>(cells_, elastic, motion::conserving(motion_), streams,
                                     Purpose::equilibration, columns(elastic.kinds, elastic.kinds.any()));
  }

  void plan(Plan& plan) const override {
    plan.cells = cells_.size();
    plan.particles_per_cell = static_cast<double>(plan.particles) / static_cast<double>(cells_.grid().size());
    plan.cell_size_in_mean_free_paths = std::pow(cells_.grid().cell_volume(), 1.0 / D) / plan.mean_free_path;
    if (reads_window()) plan.density_window = density_window();
    plan.columns = {"position", "velocity", "cell"};
    if (parameters_.kinds.mixed()) plan.columns.push_back("species");
    if (parameters_.kinds.rough) plan.columns.push_back("spin");
    if (!parameters_.weights.empty()) plan.columns.push_back("weight");
    if (scene_.output.ids) plan.columns.push_back("id");
    plan.bytes_per_particle = bytes_per_particle(static_cast<double>(plan.particles));
    plan.feature("contact factor of the local density", parameters_.factor.formula != nullptr);
    plan.feature("offset along the momentum change", parameters_.offset.consistent != 0);
    plan.feature("random offset", parameters_.offset.random != 0);
    plan.feature("momentum carried by collisions (observer pressure)", parameters_.measure_transfer);
    plan.feature("pairs expected by chance", parameters_.pair_count == PairCount::expected);
    plan.feature("clock of every cell", parameters_.pair_count == PairCount::time_counter);
    plan.feature("partners a diameter away", parameters_.partners == Partners::contact);
    plan.feature("excluded volume of cells", parameters_.excluded_volume.any());
    plan.feature("cells displaced at random", cells_.shifted_cells().has_value());
    plan.feature("cells that stand on a corner", cells_.diagonal_cells().has_value());
    plan.feature("fitted impact parameters", parameters_.impact.fitted());
    plan.feature("regions of other weights", !parameters_.weights.empty());
    plan.feature("several species", parameters_.kinds.mixed());
    plan.feature("spins and rough contacts", parameters_.kinds.rough);
    plan.feature("walls with a rule", !motion_.walls.empty());
    plan.feature("particle identities", scene_.output.ids);
    warn(plan);
  }

  void record_choices(Scene& scene) const override {
    DsmcOptions& options = std::get<DsmcOptions>(scene.method.options);
    if (reads_window()) options.density_window = density_window();
    if (!options.cells.empty() || options.cell_size) return;
    for (int axis = 0; axis < D; ++axis) options.cells.push_back(cells_.cells(axis));
  }

 private:
  std::vector<ColumnInfo> columns(const Kinds& kinds, bool ids) const {
    std::vector<ColumnInfo> columns;
    if (ids) columns.push_back(column::id);
    if (kinds.mixed()) columns.push_back(column::species);
    if (kinds.rough) columns.push_back(column::spin<D>);
    if (!parameters_.weights.empty()) columns.push_back(column::weight);
    return columns;
  }

  /// Of real particles.
  double density() const {
    return static_cast<double>(particle_count(scene_)) * scene_.method.weight / volume(scene_.domain);
  }

  /// Per cell: one window and factor; of a mixture, a window for each species and a factor for each pair.
  double bytes_of_factor() const {
    if (parameters_.factor.formula == nullptr) return 0;
    const auto species = static_cast<double>(std::max<std::size_t>(parameters_.kinds.species.size(), 1));
    return parameters_.kinds.mixed() ? 12 * species + 8 + 8 * species * species : 3 * 4 + 8;
  }
  /// Per cell: windows of particles and of pairs, and of one species the product of factors.
  double bytes_of_expected_pairs() const {
    if (parameters_.pair_count != PairCount::expected) return 0;
    const auto species = static_cast<double>(std::max<std::size_t>(parameters_.kinds.species.size(), 1));
    return 12 * species + 12 * species * (species + 1) + (parameters_.kinds.mixed() ? 0 : 8);
  }
  double bytes_of_partners() const {
    if (parameters_.partners != Partners::contact) return 0;
    return 4 + sizeof(VelocityBox<D>) +
           (parameters_.kinds.mixed() ? 4.0 * static_cast<double>(parameters_.kinds.species.size()) : 0);
  }

  /// The contact factor reads its density from a window.
  bool reads_window() const { return parameters_.factor.formula != nullptr && parameters_.factor.smoothed; }
  std::uint32_t density_window() const {
    const double particles = static_cast<double>(particle_count(scene_)) + parameters_.poured;
    return window_cells(parameters_, cells_, particles);
  }

  double bytes_per_particle(double particles) const {
    const double per_cell = 8 + bytes_of_factor() + bytes_of_expected_pairs() +
                            (parameters_.pair_count == PairCount::time_counter ? 8 : 0) +
                            bytes_of_partners() + (cells_.volumes().empty() ? 0 : 8 + 8) +
                            (parameters_.weights.empty() ? 0 : 8 + 8);
    return 2 * sizeof(Phase<D>) + sizeof(typename ParticleStore<D>::Place) + (scene_.output.ids ? 16 : 0) +
           (parameters_.kinds.mixed() ? parameters_.partners == Partners::contact ? 6 : 2 : 0) +
           (parameters_.kinds.rough ? 2 * sizeof(Spin<D>) : 0) + (parameters_.weights.empty() ? 0 : 16) +
           (parameters_.excluded_volume.any() ? 5 : 0) +
           (per_cell + (parameters_.excluded_volume.any() ? 26 + 16 * D : 0)) * cells_.size() / particles;
  }

  /// Two warnings never advise opposite things: cells as wide as a mean free path or wider get more particles by weight.
  void warn(Plan& plan) const {
    warn_of_window(plan);
    if (parameters_.excluded_volume.any()) return warn_of_full_cells(plan);
    const bool wide = plan.cell_size_in_mean_free_paths > 1;
    if (const double deficit = expected_pair_deficit(D, parameters_, density(), plan.particles_per_cell);
        deficit > 0.01)
      plan.warnings.push_back(fmt::format(
          "about {:.2g}% of the collisions and of their pressure are missing: {} cells of {:.3g} particles; "
          "use {:.0f} a cell{}",
          100 * deficit,
          parameters_.partners == Partners::contact ? "partners push each other apart in"
                                                    : "offsets take partners out of",
          plan.particles_per_cell, std::ceil(default_particles_per_cell(D, parameters_, density())),
          remedy(wide)));
    if (wide)
      plan.warnings.push_back(
          fmt::format("cells are {:.2g} mean free paths wide: transport is smeared over more than a free "
                      "path; lower 'method.cell-size'",
                      plan.cell_size_in_mean_free_paths));
    if (plan.collisions_per_particle_and_step > 0.5) warn_of_long_steps(plan);
    if (plan.particles_per_cell < 5)
      plan.warnings.push_back(fmt::format(
          "{:.2g} particles per cell: the same pairs meet again and again; {}lower 'method.weight'",
          plan.particles_per_cell, wide ? "" : "widen the cells or "));
  }

  /// The mean density of the box chooses the window. Particles that gather need less, and their density varies over it.
  void warn_of_window(Plan& plan) const {
    if (!reads_window() || parameters_.factor.window > 0) return;
    if (scene_.gravity.empty() && scene_.sources.empty()) return;
    const double packed = random_close_packing(D) * volume(scene_.domain) /
                          (parameters_.weight * particle_volume(D, parameters_.diameter));
    const std::uint32_t window = density_window(), least = window_cells(parameters_, cells_, packed);
    if (window > least)
      plan.warnings.push_back(
          fmt::format("the contact factor reads the density of {} cells across, enough at the mean density "
                      "of the box; where gravity or a source packs particles {} would do, and smear the "
                      "density less: give 'method.density-window'",
                      window, least));
  }

  /// The edge of a cell that keeps others out is a length of the model, not of the numerics: how many particles it holds is
  /// no matter of choice, and advice to widen, narrow or fill it would change the answer.
  void warn_of_full_cells(Plan& plan) const {
    const double deficit = expected_pair_deficit(D, parameters_, density(), plan.particles_per_cell);
    if (deficit > 0.01 || plan.cell_size_in_mean_free_paths > 1 || plan.particles_per_cell < 5)
      plan.warnings.push_back(fmt::format(
          "cells of {:.2g} particles, {:.2g} mean free paths wide, hold the excluded volume{}: results "
          "depend "
          "on their edge; compare two values of 'method.cell-size'",
          plan.particles_per_cell, plan.cell_size_in_mean_free_paths,
          deficit > 0.01
              ? fmt::format(" and miss about {:.2g}% of the collisions outside full ones", 100 * deficit)
              : ""));
    if (plan.collisions_per_particle_and_step > 0.5) warn_of_long_steps(plan);
  }

  static void warn_of_long_steps(Plan& plan) {
    plan.warnings.push_back(
        fmt::format("{:.2g} collisions per particle and step: moving and colliding no longer decouple; "
                    "shorten 'method.time-step'",
                    plan.collisions_per_particle_and_step));
  }

  /// How to get more particles into a cell, or to do without.
  const char* remedy(bool wide) const {
    if (parameters_.partners == Partners::contact)
      return wide ? " by a lower 'method.weight'" : ", or lower 'method.weight'";
    return wide ? " by a lower 'method.weight', or pair-count = \"expected\""
                : ", or pair-count = \"expected\"";
  }

  Scene scene_;
  Parameters parameters_;
  LatticeOfCells<D> cells_;
  motion::MotionParameters<D> motion_;
};

template <int D>
std::unique_ptr<MethodBuilder<D>> make_builder(const BuildRequest& request) {
  return std::make_unique<Builder<D>>(request);
}

}  // namespace

const FamilyBuilder& family() {
  static const FamilyBuilder all{
      "dsmc", names_of_faults(planted_faults(), boundary_faults(), exchange_faults(), step_faults()),
      make_builder<2>, make_builder<3>};
  return all;
}

}  // namespace sandglass::dsmc

#include "sim/method/mixing/family.hpp"

#include "sim/base/error.hpp"
#include "sim/method/from_scene.hpp"
#include "sim/method/mixing/mixing.hpp"
#include "sim/method/mixing/stability.hpp"

#include <algorithm>
#include <cmath>

namespace sandglass::mixing {

namespace {
using FaultChange = void (*)(Parameters&);

const std::vector<FaultEntry<FaultChange>>& planted_faults() {
  static const std::vector<FaultEntry<FaultChange>> all = {
      {{"support-counts-itself", "a particle lies on itself: its own square counts as support"},
       [](Parameters& parameters) {
         if (parameters.support) parameters.support->counts_itself = true;
       }},
      {{"support-dropped", "gravity acts in full, whatever lies below"},
       [](Parameters& parameters) { parameters.support.reset(); }},
      {{"wall-speed-factor-dropped", "walls take no speed: their factor is 1"},
       [](Parameters& parameters) { parameters.walls.speed_factor = 1; }},
      {{"wall-smallest-length-dropped", "walls divide by the whole path: none of the speed is lost there"},
       [](Parameters& parameters) { parameters.walls.smallest_length = 0; }},
      {{"repulsion-reversed", "particles attract each other"},
       [](Parameters& parameters) { parameters.faults.repulsion_sign = -1; }},
      {{"core-exponent-dropped", "no steeper repulsion below a diameter"},
       [](Parameters& parameters) { parameters.repulsion.core_exponent = 0; }},
      {{"cutoff-at-a-diameter", "no repulsion from a diameter on"},
       [](Parameters& parameters) {
         parameters.repulsion.cutoff = std::min(parameters.repulsion.cutoff, parameters.repulsion.diameter);
       }},
      {{"whole-first-kick", "the first kick lasts a step, not half a step"},
       [](Parameters& parameters) { parameters.faults.first_kick = 1; }},
  };
  return all;
}

Parameters parameters_of(const Scene& scene) {
  const MixingOptions& options = std::get<MixingOptions>(scene.method.options);
  Parameters parameters;
  const double diameter = scene.species.front().diameter;
  parameters.repulsion = {options.repulsion_coefficient, options.softening_length, options.repulsion_exponent,
                          options.core_exponent, diameter};
  if (options.cutoff) parameters.repulsion.cutoff = *options.cutoff;
  parameters.walls = {vector_of<2>(scene.domain.size), options.wall_speed_factor, options.smallest_length};
  parameters.gravity = vector_of<2>(scene.gravity)[1];
  if (!options.support_blocks.empty())
    parameters.support = SupportParameters{
        parameters.walls.box, static_cast<std::uint32_t>(options.support_blocks[0]),
        static_cast<std::uint32_t>(options.support_blocks[1]), diameter, options.smallest_length};
  for (const Species& species : scene.species) parameters.species.push_back({species.diameter, species.mass});
  parameters.keep_ids = scene.output.ids;
  return parameters;
}

class Builder final : public MethodBuilder<2> {
 public:
  explicit Builder(const BuildRequest& request) : scene_(request.scene), parameters_(parameters_of(scene_)) {
    plant(planted_faults(), request.fault, parameters_);
  }

  double collision_rate(double) const override { return 0; }
  std::unique_ptr<Simulator<2>> build(const Streams& streams, const Attachments<2>&) const override {
    return std::make_unique<Mixing>(parameters_, streams);
  }
  /// Without the loss at the walls and without gravity.
  std::unique_ptr<Simulator<2>> build_elastic(const Streams& streams) const override {
    Parameters elastic = parameters_;
    elastic.gravity = 0;
    elastic.support.reset();
    elastic.walls.speed_factor = 1;
    elastic.walls.smallest_length = 0;
    return std::make_unique<Mixing>(elastic, streams);
  }

  void plan(Plan& plan) const override {
    plan.cells = cells_of(parameters_).size();
    plan.particles_per_cell = static_cast<double>(plan.particles) / static_cast<double>(plan.cells);
    plan.columns = {"position", "velocity", "cell", "acceleration"};
    if (parameters_.species.size() > 1) plan.columns.push_back("species");
    if (parameters_.keep_ids) plan.columns.push_back("id");
    if (parameters_.support) plan.columns.push_back("square");
    plan.bytes_per_particle = 2 * sizeof(Phase<2>) + sizeof(ParticleStore<2>::Place) + sizeof(Vector<2>) +
                              sizeof(double) + (parameters_.species.size() > 1 ? 2 : 0) +
                              (parameters_.keep_ids ? 16 : 0) + (parameters_.support ? 48 : 0);
    plan.feature("several species", parameters_.species.size() > 1);
    plan.feature("support of particles by those below", parameters_.support.has_value());
    plan.feature("cutoff of the repulsion", std::isfinite(parameters_.repulsion.cutoff));
    plan.feature("steeper repulsion below a diameter", parameters_.repulsion.core_exponent > 0);
    plan.feature("particle identities", parameters_.keep_ids);
    const std::string warning = stability_warning(scene_, parameters_);
    if (!warning.empty()) plan.warnings.push_back(warning);
  }

 private:
  Scene scene_;
  Parameters parameters_;
};

std::unique_ptr<MethodBuilder<2>> make_disks(const BuildRequest& request) {
  return std::make_unique<Builder>(request);
}

/// The rules of the scene refuse it before.
std::unique_ptr<MethodBuilder<3>> make_spheres(const BuildRequest&) {
  throw InputError("the method 'mixing' is one of two dimensions: use domain.dimension = 2");
}
}  // namespace

const FamilyBuilder& family() {
  static const FamilyBuilder all{"mixing", names_of_faults(planted_faults()), make_disks, make_spheres};
  return all;
}

}  // namespace sandglass::mixing

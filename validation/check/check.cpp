#include "validation/check/check.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/scene/method/capabilities.hpp"
#include "validation/check/families.hpp"
#include "validation/law/contact.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace sandglass {

namespace {
std::vector<CheckInfo> join_families() {
  std::vector<CheckInfo> all;
  for (const auto& family : {collision_checks,
                             pressure_checks,
                             contact_checks,
                             structure_checks,
                             conservation_checks,
                             moment_checks,
                             distribution_checks,
                             cooling_checks,
                             clustering_checks,
                             guarded_checks,
                             flux_checks,
                             shear_checks,
                             few_body_checks,
                             row_checks,
                             bounce_checks,
                             knudsen_checks,
                             drag_checks,
                             column_checks,
                             column_pressure_checks,
                             pipe_flow_checks,
                             pipe_wave_checks,
                             pipe_transport_checks,
                             diffuse_wall_checks,
                             sedimentation_rest_checks,
                             sedimentation_fall_checks,
                             falling_checks,
                             packing_checks,
                             collapse_checks,
                             bagnold_checks,
                             wall_balance_checks,
                             correlation_checks,
                             pair_correlation_checks,
                             vibrated_bed_rise_checks,
                             vibrated_bed_flow_checks,
                             vibrated_bed_velocity_checks,
                             heap_checks,
                             heap_growth_checks,
                             mixture_checks,
                             rough_checks,
                             time_step_checks,
                             repulsion_checks,
                             two_fluid_checks,
                             symmetry_checks,
                             stream_checks,
                             cloning_checks,
                             open_stream_checks,
                             channel_checks,
                             falling_stream_checks})
    for (CheckInfo& check : family()) all.push_back(std::move(check));
  return all;
}

std::vector<std::string> names_of(const std::vector<law::Parameter>& parameters) {
  std::vector<std::string> names;
  for (const law::Parameter& parameter : parameters) names.push_back(parameter.name);
  return names;
}

void check_range(const CheckInfo& check, const law::Parameter& parameter, double value) {
  if (value >= parameter.low && value <= parameter.high) return;
  throw InputError(fmt::format("'{}' of check '{}' is {}: give a number from {} to {}", parameter.name,
                               check.name, value, parameter.low, parameter.high));
}

/// The case's numbers, checked, with the fallbacks of those it leaves out.
law::Arguments complete(const CheckInfo& check, const law::Arguments& given) {
  law::Arguments numbers;
  for (const law::Parameter& parameter : check.parameters) {
    const auto found = given.find(parameter.name);
    if (found == given.end() && !parameter.fallback)
      throw InputError(
          fmt::format("check '{}' needs '{}': {}", check.name, parameter.name, parameter.summary));
    const double value = found == given.end() ? *parameter.fallback : found->second;
    check_range(check, parameter, value);
    numbers[parameter.name] = value;
  }
  for (const auto& [name, value] : given)
    if (!numbers.contains(name))
      throw InputError(
          unknown_word("parameter of check '" + check.name + "'", name, names_of(check.parameters)));
  return numbers;
}

/// Where nothing is said of the resolution, a check must at least tell what it expects from nothing.
void add_case_budget(const CheckInfo& check, const Settings& settings, Evidence& evidence) {
  const double scale = check.relative ? std::abs(evidence.expected) : 1;
  const double coarsest = check.relative ? scale : 0;
  evidence.budget.systematic += settings.systematic * scale;
  evidence.budget.resolution = settings.resolution > 0 ? settings.resolution * scale : coarsest;
  if (!settings.reason.empty())
    evidence.budget.reason += (evidence.budget.reason.empty() ? "" : "; ") + settings.reason;
}

bool is_periodic(const std::array<Side, 2>& sides) {
  return sides[0] == Side::periodic && sides[1] == Side::periodic;
}
}  // namespace

const std::vector<CheckInfo>& all_checks() {
  static const std::vector<CheckInfo> all = join_families();
  return all;
}

const CheckInfo& find_check(const std::string& name) {
  std::vector<std::string> names;
  for (const CheckInfo& check : all_checks()) {
    if (check.name == name) return check;
    names.push_back(check.name);
  }
  throw InputError(unknown_word("check", name, names));
}

namespace {
bool speaks_for_itself(const CheckInfo& check) {
  return std::all_of(check.parameters.begin(), check.parameters.end(),
                     [](const law::Parameter& parameter) { return parameter.fallback.has_value(); });
}

bool fits_weights(const CheckInfo& check, const Scene& scene) {
  return check.weighs || scene.regions.empty();
}
}  // namespace

std::vector<const CheckInfo*> checks_for(const Record& record) {
  const Subject subject(record);
  std::vector<const CheckInfo*> fitting;
  for (const CheckInfo& check : all_checks()) {
    const auto measured = [&](const std::string& quantity) { return subject.has(quantity); };
    if (speaks_for_itself(check) && check.applies(subject.scene()) && fits_weights(check, subject.scene()) &&
        std::all_of(check.needs.begin(), check.needs.end(), measured))
      fitting.push_back(&check);
  }
  return fitting;
}

Evidence run_check(const CheckInfo& check, const Record& record, const Settings& settings) {
  const Subject subject(record);
  if (!fits_weights(check, subject.scene()))
    throw InputError("the check '" + check.name +
                     "' takes all particles for alike, and with a [[region]] each stands for another number "
                     "of real ones; leave it out for such a scene");
  Evidence evidence = check.evaluate(subject, complete(check, settings.numbers));
  evidence.check = check.name;
  evidence.law = check.law;
  if (evidence.summary.empty()) evidence.summary = check.summary;
  add_case_budget(check, settings, evidence);
  return evidence;
}

bool is_uniform(const Scene& scene) {
  const auto& sides = scene.domain.sides;
  const auto& gravity = scene.gravity;
  return scene.species.size() == 1 && scene.obstacles.empty() && scene.sources.empty() && !is_rough(scene) &&
         std::all_of(sides.begin(), sides.end(), is_periodic) &&
         std::all_of(gravity.begin(), gravity.end(), [](double component) { return component == 0; });
}

bool is_equilibrium(const Scene& scene) {
  return is_uniform(scene) && scene.given.empty() && scene.species.front().restitution == 1 &&
         !scene.initial.shear_wave && capabilities(scene).collisions;
}

namespace {
bool loses_energy(const Scene& scene) {
  return is_uniform(scene) && scene.given.empty() && scene.species.front().restitution < 1 &&
         !scene.initial.shear_wave && capabilities(scene).collisions;
}
}  // namespace

bool is_cooling(const Scene& scene) {
  return loses_energy(scene) && guard_of(scene.method).kind == CollapseGuard::none;
}

bool is_guarded(const Scene& scene) {
  return loses_energy(scene) && guard_of(scene.method).kind == CollapseGuard::contact_time;
}

law::Parameter contact_number() {
  return {
      "contact-value", "1", "of the method, where it has none of its gas; 0: that of the gas", 0, 100, 0.0};
}

double contact_ratio(const Subject& subject, double contact_value) {
  const law::Gas gas = subject.gas(1);
  return contact_value > 0 ? contact_value / law::contact_value(gas.dimension, gas.fraction) : 1;
}

bool touches(const Scene& scene) { return capabilities(scene).contacts; }

}  // namespace sandglass

#include "validation/suite/matrix.hpp"

#include "validation/suite/overlay.hpp"

#include <algorithm>

namespace sandglass {

namespace {
std::vector<const CheckUse*> checks_of(const Case& subject, const std::string& variant,
                                       const std::string& point) {
  std::vector<const CheckUse*> checks;
  for (const CheckUse& use : subject.checks)
    if (use.where.holds(point, variant)) checks.push_back(&use);
  return checks;
}
}  // namespace

Scene scene_of(const Case& subject, const std::string& tier, const std::string& variant,
               const std::string& point, const Override& on_top) {
  const Tier chosen = subject.tier(tier);
  const Variant& by = subject.variant(variant);
  std::vector<const Override*> layers{&subject.point(point).set};
  for (const Override& set : by.sets) layers.push_back(&set);
  for (const TierChange& change : chosen.changes)
    if (change.where.holds(point, variant)) layers.push_back(&change.set);
  layers.push_back(&on_top);
  for (const Override& setting : subject.settings) layers.push_back(&setting);
  return lay_over(subject.scene, subject.scene_file, layers, by.added);
}

std::vector<Task> expand(const Case& subject, const std::string& tier, const std::string& only_variant) {
  const Tier chosen = subject.tier(tier);
  std::vector<Task> tasks;
  for (const Variant& variant : subject.variants)
    for (const Point& point : subject.points) {
      if (!only_variant.empty() && variant.name != only_variant) continue;
      if (!subject.runs(point.name, variant.name) || !chosen.where.holds(point.name, variant.name)) continue;
      Task task{&subject, variant.name, point.name, scene_of(subject, tier, variant.name, point.name, {}),
                checks_of(subject, variant.name, point.name)};
      if (!task.checks.empty()) tasks.push_back(std::move(task));
    }
  return tasks;
}

std::uint64_t derived_seed(std::uint64_t seed, const std::string& name) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, 64 bits
  const auto mix = [&hash](unsigned char byte) { hash = (hash ^ byte) * 0x100000001b3; };
  for (int byte = 0; byte < 8; ++byte) mix(static_cast<unsigned char>(seed >> (8 * byte)));
  for (const char c : name) mix(static_cast<unsigned char>(c));
  return hash >> 1;
}

}  // namespace sandglass

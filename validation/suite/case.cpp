#include "validation/suite/case.hpp"

#include <algorithm>

namespace sandglass {

namespace {
bool chosen(const std::vector<std::string>& list, const std::string& name) {
  return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
}

template <class Entry>
const Entry& named(const std::vector<Entry>& entries, const std::string& name) {
  return *std::find_if(entries.begin(), entries.end(),
                       [&](const Entry& entry) { return entry.name == name; });
}
}  // namespace

bool Selection::holds(const std::string& point, const std::string& variant) const {
  return chosen(points, point) && chosen(variants, variant);
}

bool KnownLimit::holds(const std::string& point, const std::string& variant) const {
  return where.holds(point, variant) &&
         std::ranges::none_of(lifted, [&](const Selection& free) { return free.holds(point, variant); });
}

const KnownLimit* CheckUse::known_limit(const std::string& point, const std::string& variant) const {
  const auto found =
      std::ranges::find_if(limits, [&](const KnownLimit& limit) { return limit.holds(point, variant); });
  return found == limits.end() ? nullptr : &*found;
}

bool Case::runs(const std::string& at, const std::string& by) const {
  return Selection{variant(by).points, point(at).variants}.holds(at, by);
}

const CheckUse* Case::use_of(const std::string& check, const std::string& at, const std::string& by) const {
  if (!runs(at, by)) return nullptr;
  const auto found = std::ranges::find_if(
      checks, [&](const CheckUse& use) { return use.check == check && use.where.holds(at, by); });
  return found == checks.end() ? nullptr : &*found;
}

const Point& Case::point(const std::string& wanted) const { return named(points, wanted); }

const Variant& Case::variant(const std::string& wanted) const { return named(variants, wanted); }

Tier Case::tier(const std::string& wanted) const {
  for (const Tier& tier : tiers)
    if (tier.name == wanted) return tier;
  Tier whole;
  whole.name = wanted;
  return whole;
}

const std::vector<std::string>& tier_names() {
  static const std::vector<std::string> names{"smoke", "standard", "paper"};
  return names;
}

}  // namespace sandglass

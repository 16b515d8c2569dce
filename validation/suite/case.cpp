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

bool CheckUse::is_known_limit(const std::string& point, const std::string& variant) const {
  return std::any_of(limits.begin(), limits.end(),
                     [&](const KnownLimit& limit) { return limit.where.holds(point, variant); });
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

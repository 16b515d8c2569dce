#pragma once

#include "sim/scene/text/document.hpp"
#include "validation/check/check.hpp"

#include <string>
#include <vector>

// A case as data: what validation/case/<topic>/<name>/case.toml says. docs/add-a-case.md explains every key.

namespace sandglass {

struct Equation {
  std::string tex, text, citation;
};

/// A choice of points and variants; an empty list means all.
struct Selection {
  std::vector<std::string> points, variants;
  bool holds(const std::string& point, const std::string& variant) const;
};

/// Values that replace those of the base scene, as a TOML table of the same shape, and where they stand.
struct Override {
  Node values;
  std::string file;
};

struct Point {
  std::string name, summary;
  std::vector<std::string> variants;  ///< empty: all
  Override set;
};

struct Variant {
  std::string name, summary;
  std::vector<std::string> points;  ///< empty: all
  Override set;
};

/// The source itself says that the method cannot do this: the check must fail here.
struct KnownLimit {
  Selection where;
  std::string reason;
};

struct CheckUse {
  std::string check;
  std::string claim;
  Settings settings;
  Selection where;
  std::vector<KnownLimit> limits;
  bool is_known_limit(const std::string& point, const std::string& variant) const;
};

struct TierChange {
  Selection where;
  Override set;
};

/// What a tier runs of a case and how long. A tier that the case does not mention runs all of it as it
/// stands.
struct Tier {
  std::string name;
  Selection where;
  bool sweeps = true;
  std::vector<TierChange> changes;
};

struct SweepPoint {
  double knob = 0;
  Override set;
};

/// Error against cost for one knob of the method. The reference is a run of its own with `reference`.
struct Sweep {
  std::string knob, label, variant, point, quantity, reference_source;
  CheckUse use;  ///< whose value is followed; the sweep needs no verdict of it
  double expected_order = 0;
  Override reference;
  std::vector<SweepPoint> points;
};

/// A planted fault and the check that must see it.
struct Mutant {
  std::string mutation, check, variant, point;
  Override set;
};

struct Case {
  std::string folder;
  std::string name, topic, summary, question, readme;
  std::vector<std::string> claims;
  std::vector<Equation> equations;
  std::string scene_file;
  Node scene;
  std::vector<Point> points;
  std::vector<Variant> variants;
  std::vector<CheckUse> checks;
  std::vector<Tier> tiers;
  std::vector<Sweep> sweeps;
  std::vector<Mutant> mutants;

  const Point& point(const std::string& name) const;
  const Variant& variant(const std::string& name) const;
  Tier tier(const std::string& name) const;
};

/// Reads case.toml, scene.toml and README.md of a folder. Throws InputError with every fault of case.toml,
/// each with its place, the allowed words and the nearest spelling.
Case read_case(const std::string& folder);

/// Every case below a folder, sorted by topic and name.
std::vector<Case> read_cases(const std::string& folder);

/// "smoke", "standard", "paper"
const std::vector<std::string>& tier_names();

}  // namespace sandglass

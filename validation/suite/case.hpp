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

/// A choice of points and variants by name, patterns already resolved; an empty list means all.
struct Selection {
  std::vector<std::string> points, variants;
  bool holds(const std::string& point, const std::string& variant) const;
};

/// What a tier multiplies: replicas, duration, and the number of particles at the same density.
struct Factors {
  double replicas = 1, duration = 1, size = 1;
  Place place = {};
};

/// Values that replace those of the base scene, as a TOML table of the same shape, and where they stand; the factors
/// come after them.
struct Override {
  Node values;
  std::string file;
  Factors factors = {};
};

/// Observers that a variant adds to the scene: a list of tables. One without `every` samples as the scene's last does.
struct AddedObservers {
  Node list;
  std::string file;
};

struct Point {
  std::string name, summary;
  std::vector<std::string> tags;
  std::vector<std::string> variants;  ///< empty: all
  Override set;
};

struct Variant {
  std::string name, summary;
  std::vector<std::string> tags;
  std::vector<std::string> points;  ///< empty: all
  std::vector<Override> sets;       ///< of the shared file, then of the case
  std::vector<AddedObservers> added;
};

/// The source itself says that the method cannot do this: the check must fail here.
struct KnownLimit {
  Selection where;
  std::string reason;
  law::Arguments
      instead;  ///< numbers of the check with which it must pass; empty: nothing is said of the size
  std::vector<Selection> lifted;  ///< where the case says that it can after all
  bool holds(const std::string& point, const std::string& variant) const;
};

struct CheckUse {
  std::string check;
  std::string claim;
  Settings settings;
  Selection where;
  std::vector<KnownLimit> limits;
  /// The limit that the check must show here; null when there is none.
  const KnownLimit* known_limit(const std::string& point, const std::string& variant) const;
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
  std::string fault, check, variant, point;
  law::Arguments numbers;  ///< in place of those of the check: where the source's own number is a known limit
  Override set;
  /// From the run that the matrix has there.
  bool differs() const { return !numbers.empty() || !set.values.items.empty(); }
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
  std::vector<Override> settings = {};  ///< of the command line: over every scene, on top of all else

  /// The variant runs at the point, in some tier.
  bool runs(const std::string& point, const std::string& variant) const;
  /// The check as it is made there; null when it is not.
  const CheckUse* use_of(const std::string& check, const std::string& point,
                         const std::string& variant) const;
  const Point& point(const std::string& name) const;
  const Variant& variant(const std::string& name) const;
  Tier tier(const std::string& name) const;
};

/// Reads case.toml, scene.toml and README.md of a folder, and variants.toml two folders above, which says what the
/// variants of all cases are. Throws InputError with every error of case.toml, each with its place, the allowed words and
/// the nearest spelling.
Case read_case(const std::string& folder);

/// Every case below a folder, sorted by topic and name.
std::vector<Case> read_cases(const std::string& folder);

/// "smoke", "standard", "paper"
const std::vector<std::string>& tier_names();

}  // namespace sandglass

#include "validation/suite/case_rules.hpp"

#include "sim/base/spelling.hpp"
#include "sim/run/run.hpp"

#include <algorithm>

namespace sandglass {

namespace {
template <class Entry>
std::vector<std::string> names_of(const std::vector<Entry>& entries) {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

/// What can be named, and where a wrong name is reported.
class Rules {
 public:
  Rules(const Case& subject, Diagnostics& diagnostics)
      : points_(names_of(subject.points)),
        variants_(names_of(subject.variants)),
        checks_(names_of(all_checks())),
        mutations_(names_of(planted_faults())),
        diagnostics_(diagnostics) {}

  void known(const std::string& kind, const std::string& word, const std::vector<std::string>& allowed,
             const std::string& path) {
    if (word.empty() || std::find(allowed.begin(), allowed.end(), word) != allowed.end()) return;
    diagnostics_.report(path, unknown_word(kind, word, allowed));
  }
  void point(const std::string& word, const std::string& path) { known("point", word, points_, path); }
  void variant(const std::string& word, const std::string& path) { known("variant", word, variants_, path); }
  void check(const std::string& word, const std::string& path) { known("check", word, checks_, path); }
  void numbers(const CheckUse& use, const std::string& path) {
    if (std::find(checks_.begin(), checks_.end(), use.check) == checks_.end()) return;
    const std::vector<std::string> allowed = names_of(find_check(use.check).parameters);
    for (const auto& [name, value] : use.settings.numbers) known("number", name, allowed, path + "." + name);
  }
  void mutation(const std::string& word, const std::string& path) {
    known("mutation", word, mutations_, path);
  }
  void selection(const Selection& where, const std::string& path) {
    for (std::size_t i = 0; i < where.points.size(); ++i)
      point(where.points[i], item_path(path + ".points", i));
    for (std::size_t i = 0; i < where.variants.size(); ++i)
      variant(where.variants[i], item_path(path + ".variants", i));
  }
  void unique(const std::vector<std::string>& names, const std::string& key) {
    for (std::size_t i = 0; i < names.size(); ++i)
      if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
          names.begin() + static_cast<std::ptrdiff_t>(i))
        diagnostics_.report(item_path(key, i) + ".name",
                            "the name '" + names[i] + "' is given twice; keep one");
  }
  void needed(bool present, const std::string& key) {
    if (!present) diagnostics_.report(key, "a case needs at least one [[" + key + "]]");
  }

 private:
  std::vector<std::string> points_, variants_, checks_, mutations_;
  Diagnostics& diagnostics_;
};

void check_uses(const Case& subject, Rules& rules) {
  for (std::size_t i = 0; i < subject.checks.size(); ++i) {
    const CheckUse& use = subject.checks[i];
    const std::string path = item_path("check", i);
    rules.check(use.check, path + ".check");
    rules.numbers(use, path + ".numbers");
    rules.selection(use.where, path);
    for (std::size_t j = 0; j < use.limits.size(); ++j)
      rules.selection(use.limits[j].where, item_path(path + ".known-limit", j));
  }
}

void check_tiers(const Case& subject, Rules& rules) {
  for (std::size_t i = 0; i < subject.tiers.size(); ++i) {
    const std::string path = item_path("tier", i);
    rules.known("tier", subject.tiers[i].name, tier_names(), path + ".name");
    rules.selection(subject.tiers[i].where, path);
    for (std::size_t j = 0; j < subject.tiers[i].changes.size(); ++j)
      rules.selection(subject.tiers[i].changes[j].where, item_path(path + ".change", j));
  }
}

void check_sweeps(const Case& subject, Rules& rules) {
  for (std::size_t i = 0; i < subject.sweeps.size(); ++i) {
    const std::string path = item_path("sweep", i);
    rules.point(subject.sweeps[i].point, path + ".point");
    rules.variant(subject.sweeps[i].variant, path + ".variant");
    rules.check(subject.sweeps[i].use.check, path + ".check");
  }
}

void check_mutants(const Case& subject, Rules& rules) {
  for (std::size_t i = 0; i < subject.mutants.size(); ++i) {
    const std::string path = item_path("mutant", i);
    rules.point(subject.mutants[i].point, path + ".point");
    rules.variant(subject.mutants[i].variant, path + ".variant");
    rules.check(subject.mutants[i].check, path + ".check");
    rules.mutation(subject.mutants[i].mutation, path + ".mutation");
  }
}
}  // namespace

void check_case_rules(const Case& subject, Diagnostics& diagnostics) {
  Rules rules(subject, diagnostics);
  rules.needed(!subject.points.empty(), "point");
  rules.needed(!subject.variants.empty(), "variant");
  rules.needed(!subject.checks.empty(), "check");
  rules.unique(names_of(subject.points), "point");
  rules.unique(names_of(subject.variants), "variant");
  rules.unique(names_of(subject.tiers), "tier");
  check_uses(subject, rules);
  check_tiers(subject, rules);
  for (std::size_t i = 0; i < subject.variants.size(); ++i)
    rules.selection({subject.variants[i].points, {}}, item_path("variant", i));
  for (std::size_t i = 0; i < subject.points.size(); ++i)
    rules.selection({{}, subject.points[i].variants}, item_path("point", i));
  check_sweeps(subject, rules);
  check_mutants(subject, rules);
}

}  // namespace sandglass

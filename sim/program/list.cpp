#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/program/claims.hpp"
#include "sim/program/folders.hpp"
#include "sim/program/options.hpp"
#include "sim/program/table.hpp"
#include "sim/program/templates.hpp"
#include "sim/run/run.hpp"
#include "sim/scene/method/family.hpp"
#include "validation/check/check.hpp"
#include "validation/law/law.hpp"
#include "validation/suite/suite.hpp"

#include <functional>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandglass::program {

namespace {

using Entries = nlohmann::json;  ///< array of objects with at least name and summary

template <class Range>
Entries names_of(const Range& range) {
  Entries entries = Entries::array();
  for (const auto& item : range) entries.push_back({{"name", item.name}, {"summary", item.summary}});
  return entries;
}

Entries laws() {
  Entries entries = Entries::array();
  for (const law::Law& law : law::all_laws()) {
    Entries parameters = Entries::array();
    for (const law::Parameter& parameter : law.parameters)
      parameters.push_back(
          {{"name", parameter.name}, {"units", parameter.units}, {"summary", parameter.summary}});
    entries.push_back({{"name", law.name},
                       {"summary", law.summary},
                       {"source", law.source},
                       {"units", law.units},
                       {"validity", law.validity},
                       {"parameters", parameters}});
  }
  return entries;
}

Entries checks() {
  Entries entries = Entries::array();
  for (const CheckInfo& check : all_checks())
    entries.push_back(
        {{"name", check.name}, {"summary", check.summary}, {"law", check.law}, {"needs", check.needs}});
  return entries;
}

Entries cases() {
  Entries entries = Entries::array();
  for (const CaseSummary& item : list_cases(case_folder()))
    entries.push_back({{"name", item.name},
                       {"summary", item.summary},
                       {"topic", item.topic},
                       {"variants", item.variants},
                       {"points", item.points},
                       {"claims", item.claims}});
  return entries;
}

Entries claims() {
  Entries entries = Entries::array();
  for (const Claim& claim : read_claims(claims_file()))
    entries.push_back({{"name", claim.id},
                       {"summary", claim.text},
                       {"source", claim.source},
                       {"status", claim.status},
                       {"evidence", claim.evidence}});
  return entries;
}

const std::map<std::string, std::function<Entries()>>& lists() {
  static const std::map<std::string, std::function<Entries()>> all = {
      {"methods", [] { return names_of(preset_summaries()); }},
      {"observers", [] { return names_of(observer_summaries()); }},
      {"laws", laws},
      {"checks", checks},
      {"cases", cases},
      {"claims", claims},
      {"mutations", [] { return names_of(planted_faults()); }},
      {"templates", [] { return names_of(templates()); }},
  };
  return all;
}

}  // namespace

int list(const Options& options) {
  const auto found = lists().find(options.subject);
  if (found == lists().end()) {
    std::vector<std::string> words;
    for (const auto& [word, make] : lists()) words.push_back(word);
    throw InputError(unknown_word("list", options.subject, words));
  }
  const Entries entries = found->second();
  if (options.json) {
    fmt::print("{}\n", entries.dump(2));
    return all_well;
  }
  std::vector<std::vector<std::string>> rows;
  for (const auto& entry : entries) rows.push_back({entry.at("name"), entry.at("summary")});
  fmt::print("{}", columns(rows));
  return all_well;
}

}  // namespace sandglass::program

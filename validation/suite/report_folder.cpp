#include "validation/suite/report_folder.hpp"

#include "sim/base/error.hpp"
#include "validation/suite/json.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace sandglass {

namespace {
namespace fs = std::filesystem;

/// To a new file, then renamed: a reader never sees half of it. Numbers that are not finite become null.
void write_json(const fs::path& path, const Json& json) {
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  const fs::path fresh = path.string() + ".new";
  std::ofstream file(fresh);
  file << json.dump(1) << '\n';
  file.close();
  if (!file) throw RunError(fresh.string() + ": cannot be written: " + std::strerror(errno));
  std::error_code error;
  fs::rename(fresh, path, error);
  if (error) throw RunError(path.string() + ": cannot be written: " + error.message());
}

Json evidence_json(const Outcome& outcome, const CheckOutcome& check) {
  Json json = verdict_json(outcome, check);
  json["law"] = check.evidence.law;
  json["figures"] = Json::array();
  for (const Figure& figure : check.evidence.figures) json["figures"].push_back(figure_json(figure));
  return json;
}

Json sweep_json(const SweepResult& result) {
  Json points = Json::array();
  for (const SweepValue& value : result.points)
    points.push_back({{"knob", value.knob},
                      {"value", value.value},
                      {"stderr", value.standard_error},
                      {"error", value.error},
                      {"cpu_seconds", value.cpu_seconds},
                      {"work", value.work}});
  const Sweep& sweep = *result.sweep;
  return {{"case", result.case_name},
          {"variant", sweep.variant},
          {"knob", sweep.knob},
          {"knob_label", sweep.label},
          {"quantity", sweep.quantity},
          {"units", result.units},
          {"reference", result.reference},
          {"reference_error", result.reference_error},
          {"reference_source", sweep.reference_source},
          {"expected_order", sweep.expected_order},
          {"points", points},
          {"order", result.order},
          {"order_stderr", result.order_error},
          {"order_reason", result.order_reason}};
}
}  // namespace

void write_verdicts(const std::string& folder, const std::vector<Outcome>& outcomes) {
  Json json = Json::array();
  for (const Outcome& outcome : outcomes)
    for (const CheckOutcome& check : outcome.checks) json.push_back(verdict_json(outcome, check));
  write_json(fs::path(folder) / "verdicts.json", json);
}

void write_evidence(const std::string& folder, const Case& subject, const std::vector<Outcome>& outcomes) {
  Json json{{"case", subject.name},         {"topic", subject.topic},   {"summary", subject.summary},
            {"question", subject.question}, {"claims", subject.claims}, {"equations", Json::array()},
            {"readme", subject.readme},     {"runs", Json::array()},    {"evidence", Json::array()}};
  for (const Equation& equation : subject.equations)
    json["equations"].push_back(
        {{"tex", equation.tex}, {"text", equation.text}, {"citation", equation.citation}});
  for (const Outcome& outcome : outcomes) {
    if (outcome.case_name != subject.name) continue;
    json["runs"].push_back(run_json(outcome.run));
    for (const CheckOutcome& check : outcome.checks)
      json["evidence"].push_back(evidence_json(outcome, check));
  }
  write_json(fs::path(folder) / "evidence" / (subject.name + ".json"), json);
}

void write_sweeps(const std::string& folder, const std::vector<SweepResult>& sweeps) {
  Json json = Json::array();
  for (const SweepResult& sweep : sweeps) json.push_back(sweep_json(sweep));
  write_json(fs::path(folder) / "sweeps.json", json);
}

void write_mutants(const std::string& folder, const std::vector<MutantResult>& mutants) {
  Json json = Json::array();
  for (const MutantResult& mutant : mutants)
    json.push_back({{"mutation", mutant.fault},
                    {"summary", mutant.summary},
                    {"case", mutant.case_name},
                    {"variant", mutant.variant},
                    {"point", mutant.point},
                    {"check", mutant.check.evidence.check},
                    {"verdict", to_string(mutant.check.judgement.verdict)},
                    {"caught", mutant.caught},
                    {"value", mutant.check.evidence.value},
                    {"stderr", mutant.check.evidence.standard_error},
                    {"kind", to_string(mutant.check.evidence.kind)},
                    {"expected", mutant.check.evidence.expected},
                    {"budget", mutant.check.judgement.budget}});
  write_json(fs::path(folder) / "mutants.json", json);
}

void write_keys(const std::string& folder, const std::vector<KeyResult>& keys) {
  Json json = Json::array();
  for (const KeyResult& key : keys) {
    Json trials = Json::array();
    for (const KeyTrial& trial : key.trials)
      trials.push_back({{"case", trial.case_name},
                        {"variant", trial.variant},
                        {"point", trial.point},
                        {"how", trial.how},
                        {"check", trial.check}});
    json.push_back({{"key", key.key},
                    {"family", key.family},
                    {"used", key.is_used},
                    {"seen", key.seen()},
                    {"trials", trials}});
  }
  write_json(fs::path(folder) / "keys.json", json);
}

}  // namespace sandglass

#include "validation/suite/json.hpp"

namespace sandglass {

namespace {
Json axis_json(const Figure::Axis& axis) {
  return {{"label", axis.label}, {"units", axis.units}, {"logarithmic", axis.logarithmic}};
}

/// Each part as the judge counts it; the statistical and the reference part add in quadrature.
Json budget_json(const Evidence& evidence, const Judgement& judgement) {
  const Budget& budget = evidence.budget;
  return {{"statistical", judgement.coverage * evidence.standard_error},
          {"reference", judgement.coverage * budget.reference},
          {"systematic", budget.systematic},
          {"reason", budget.reason},
          {"resolution", budget.resolution}};
}

/// The attempt that a longer run replaced.
Json first_attempt_json(const Outcome& outcome, const std::string& check) {
  for (const CheckOutcome& first : outcome.first_attempt)
    if (first.evidence.check == check)
      return {{"verdict", to_string(first.judgement.verdict)},
              {"value", first.evidence.value},
              {"stderr", first.evidence.standard_error},
              {"reason", first.judgement.reason},
              {"seed", outcome.first_seed}};
  return nullptr;
}
}  // namespace

Json verdict_json(const Outcome& outcome, const CheckOutcome& check) {
  const Evidence& evidence = check.evidence;
  const Judgement& judgement = check.judgement;
  Json json{{"case", outcome.case_name},
            {"variant", outcome.run.variant},
            {"point", outcome.run.point},
            {"check", evidence.check},
            {"claim", check.claim},
            {"summary", evidence.summary},
            {"units", evidence.units},
            {"verdict", to_string(judgement.verdict)},
            {"reason", judgement.reason},
            {"value", evidence.value},
            {"stderr", evidence.standard_error},
            {"kind", to_string(evidence.kind)},
            {"expected", evidence.expected},
            {"deviation", judgement.deviation},
            {"budget", judgement.budget},
            {"budget_parts", budget_json(evidence, judgement)},
            {"cpu_seconds", outcome.run.cpu_seconds},
            {"work", outcome.run.work},
            {"work_units", "particle-moves"},
            {"peak_bytes", outcome.run.peak_bytes},
            {"seed", outcome.run.seed},
            {"tier", outcome.tier}};
  if (evidence.kind == Expectation::between) json["upper"] = evidence.upper;
  if (check.known_limit) json["known_limit"] = check.limit_reason;
  if (!outcome.first_attempt.empty()) json["first_attempt"] = first_attempt_json(outcome, evidence.check);
  return json;
}

Json figure_json(const Figure& figure) {
  Json points = Json::array(), lines = Json::array();
  for (const Figure::Points& set : figure.points)
    points.push_back(
        {{"name", set.name}, {"x", set.x}, {"y", set.y}, {"error", set.error}, {"expected", set.expected}});
  for (const Figure::Line& line : figure.lines)
    lines.push_back({{"name", line.name}, {"x", line.x}, {"y", line.y}});
  return {{"title", figure.title},
          {"x", axis_json(figure.x)},
          {"y", axis_json(figure.y)},
          {"points", points},
          {"lines", lines}};
}

Json run_json(const RunSummary& run) {
  return {{"variant", run.variant},
          {"point", run.point},
          {"seed", run.seed},
          {"scene", run.scene},
          {"record", run.record_path},
          {"cpu_seconds", run.cpu_seconds},
          {"wall_seconds", run.wall_seconds},
          {"peak_bytes", run.peak_bytes},
          {"work", run.work},
          {"work_units", "particle-moves"},
          {"counters", run.counters},
          {"provenance",
           {{"program_version", run.provenance.program_version},
            {"commit", run.provenance.commit},
            {"build", run.provenance.build},
            {"created", run.provenance.created}}}};
}

}  // namespace sandglass

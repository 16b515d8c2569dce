#include "validation/check/check.hpp"

#include "sim/base/error.hpp"
#include "sim/program/options.hpp"
#include "sim/program/table.hpp"
#include "sim/record/describe.hpp"
#include "validation/judge/judge.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace sandglass::program {

int check(const Options& options) {
  const Record record = read_record(options.subject);
  const std::vector<const CheckInfo*> checks = checks_for(record);
  if (checks.empty())
    throw InputError(
        options.subject +
        ": no check applies: none finds the series that it needs. `sandglass list checks` names them");
  nlohmann::json json = nlohmann::json::array();
  std::vector<std::vector<std::string>> rows = {
      {"check", "verdict", "value", "standard error", "expected", "budget", "units"}};
  bool all_hold = true;
  for (const CheckInfo* info : checks) {
    const Evidence evidence = run_check(*info, record, {});
    const Judgement judgement = judge(evidence, {}, false);
    all_hold = all_hold && !blocks(judgement.verdict);
    rows.push_back({evidence.check, to_string(judgement.verdict), fmt::format("{:.6g}", evidence.value),
                    fmt::format("{:.2g}", evidence.standard_error), fmt::format("{:.6g}", evidence.expected),
                    fmt::format("{:.2g}", judgement.budget), evidence.units});
    json.push_back({{"check", evidence.check},
                    {"verdict", to_string(judgement.verdict)},
                    {"reason", judgement.reason},
                    {"value", evidence.value},
                    {"stderr", evidence.standard_error},
                    {"expected", evidence.expected},
                    {"budget", judgement.budget},
                    {"units", evidence.units}});
  }
  fmt::print("{}", options.json ? json.dump(2) + "\n" : describe_record(record) + "\n" + columns(rows));
  return all_hold ? all_well : verdict_fails;
}

}  // namespace sandglass::program

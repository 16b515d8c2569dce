#include "validation/suite/suite.hpp"

#include "sim/base/error.hpp"
#include "sim/run/run.hpp"
#include "validation/suite/pool.hpp"
#include "validation/suite/synthetic_case.hpp"

#include <atomic>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace sandglass::suite_test {
namespace {

constexpr const char* mutant =
    "[[mutant]]\nmutation = \"restitution-minus-2-percent\"\ncheck = \"energy-conservation\"\nvariants = "
    "\"dsmc\"\n"
    "points = \"one\"\n";

SuiteOptions options_of(const SyntheticCase& files) {
  SuiteOptions options;
  options.case_folder = files.root().string();
  options.output = (files.root() / "report").string();
  options.jobs = 2;
  return options;
}

nlohmann::json read_json(const SyntheticCase& files, const std::string& name) {
  std::ifstream file(files.root() / "report" / name);
  return nlohmann::json::parse(file);
}

TEST(Suite, FillsTheReportFolder) {
  const SyntheticCase files(mutant);
  const SuiteResult result = run_suite(options_of(files));
  EXPECT_FALSE(result.blocked());
  const nlohmann::json verdicts = read_json(files, "verdicts.json");
  ASSERT_EQ(verdicts.size(), 1U);
  EXPECT_EQ(verdicts[0]["verdict"], "pass");
  EXPECT_EQ(verdicts[0]["seed"], 3);
  const nlohmann::json evidence = read_json(files, "evidence/small.json");
  EXPECT_EQ(evidence["readme"], "# Small\n");
  EXPECT_GT(evidence["runs"][0]["work"], 0);
  EXPECT_TRUE(
      std::filesystem::exists(files.root() / "report" / evidence["runs"][0]["record"].get<std::string>()));
  EXPECT_TRUE(read_json(files, "sweeps.json").empty());
}

TEST(Suite, ResultDoesNotDependOnThreads) {
  const SyntheticCase files(
      "[[check]]\ncheck = \"momentum-conservation\"\n[[variant]]\nname = \"cba\"\nset.method.preset = "
      "\"cba\"\n");
  SuiteOptions options = options_of(files);
  run_suite(options);
  nlohmann::json two = read_json(files, "verdicts.json");
  options.jobs = 1;
  run_suite(options);
  nlohmann::json one = read_json(files, "verdicts.json");
  for (nlohmann::json* verdicts : {&one, &two})
    for (nlohmann::json& verdict : *verdicts) verdict.erase("cpu_seconds");
  EXPECT_EQ(one, two);
}

TEST(Suite, PlantedFaultIsCaught) {
  const SyntheticCase files(mutant);
  SuiteOptions options = options_of(files);
  options.mutants = true;
  EXPECT_FALSE(run_suite(options).blocked());
  EXPECT_TRUE(read_json(files, "mutants.json")[0]["caught"]);
}

TEST(Suite, CheckWithoutItsSeriesBlocksAndSaysWhy) {
  const SyntheticCase files("[[check]]\ncheck = \"compressibility\"\n");
  const SuiteResult result = run_suite(options_of(files));
  EXPECT_TRUE(result.blocked());
  const Judgement& judgement = result.outcomes.at(0).checks.at(1).judgement;
  EXPECT_EQ(judgement.verdict, Verdict::inconclusive);
  EXPECT_THAT(judgement.reason, testing::HasSubstr("no series 'pressure'"));
  EXPECT_TRUE(read_json(files, "verdicts.json")[1]["value"].is_null());
}

TEST(Suite, FreshSeedIsDerivedAndRecorded) {
  const SyntheticCase files;
  SuiteOptions options = options_of(files);
  options.seed = 42;
  run_suite(options);
  EXPECT_EQ(read_json(files, "verdicts.json")[0]["seed"], derived_seed(42, "small/dsmc/one"));
}

TEST(Suite, UnknownNamesAreRefused) {
  const SyntheticCase files;
  SuiteOptions options = options_of(files);
  options.cases = {"smal"};
  EXPECT_THROW(run_suite(options), InputError);
  options.cases = {};
  options.tier = "stndard";
  EXPECT_THROW(run_suite(options), InputError);
}

TEST(Suite, NothingToRunIsRefused) {
  const SyntheticCase files(
      "[[variant]]\nname = \"cba\"\nset.method.preset = \"cba\"\n[[tier]]\nname = \"smoke\"\nvariants = "
      "[\"dsmc\"]\n");
  SuiteOptions options = options_of(files);
  options.variant = "cba";
  EXPECT_FALSE(run_suite(options).outcomes.empty());
  options.tier = "smoke";
  EXPECT_THROW(run_suite(options), InputError);
}

/// Without its guard the row collapses, and the run stops.
TEST(Suite, FaultThatBreaksTheRunIsNotCaught) {
  const Scene row = read_scene_text(R"(
run = { duration = { time = 1.0 } }
domain = { dimension = 2, size = [20.0, 20.0] }
method = { preset = "event-driven", time-step = 0.1, collapse-guard = "contact-time", contact-time = 1e-3 }
species = [{ restitution = 0.05 }]
initial = { positions = "given" }
particle = [{ position = [9.0, 10.0], velocity = [1.0, 0.0] },
            { position = [10.2, 10.0], velocity = [0.0, 0.0] },
            { position = [11.7, 10.0], velocity = [-1.0, 0.0] }]
observe = [{ what = "energy" }]
)",
                                    "row.toml");
  const Case subject;
  const CheckUse use{"momentum-conservation", "", {}, {}, {}};
  const Task task{&subject, "event-driven", "row", row, {&use}};
  const MutantResult result =
      judge_mutant(task, {"guard-dropped", use.check, task.variant, task.point, {}, {}}, {});
  EXPECT_FALSE(result.caught);
  EXPECT_THAT(result.check.judgement.reason, testing::HasSubstr("the run broke: inelastic collapse"));
}

/// A run that fails by itself catches nothing: here nobody conserves the energy.
TEST(Mutants, TheSameRunWithoutTheFaultMustNotFail) {
  const Scene scene = read_scene_text(
      "run = { duration = { collisions-per-particle = 2.0 } }\n"
      "species = [{ count = 100, area-fraction = 0.1, restitution = 0.5 }]\ndomain = { dimension = 2 }\n"
      "method = { preset = \"dsmc\", time-step = { collisions-per-particle = 0.1 } }\n"
      "observe = [{ what = \"energy\" }, { what = \"collisions\" }]\n",
      "cooling.toml");
  const Case subject;
  const CheckUse use{"energy-conservation", "", {}, {}, {}};
  const Task task{&subject, "dsmc", "cooling", scene, {&use}};
  Mutant planted{"restitution-minus-2-percent", use.check, task.variant, task.point, {}, {}};
  EXPECT_TRUE(judge_mutant(task, planted, {}).caught);  // as in the matrix, which judges that run
  planted.set.values.items.emplace_back();
  const MutantResult result = judge_mutant(task, planted, {});
  EXPECT_FALSE(result.caught);
  EXPECT_THAT(result.check.judgement.reason, testing::HasSubstr("without the fault fails too"));
}

/// What a limit does to the verdict on a gas without collisional pressure, when its source has it carry that part of it.
Verdict limit_of(double carried) {
  const Scene scene = read_scene_text(
      "run = { duration = { collisions-per-particle = 5.0 } }\nspecies = [{ count = 200, area-fraction = 0.2 "
      "}]\n"
      "domain = { dimension = 2 }\nmethod = { preset = \"dsmc\", time-step = { collisions-per-particle = 0.1 "
      "} }\n"
      "observe = [{ what = \"pressure\", every = { collisions-per-particle = 1.0 } }]\n",
      "scene.toml");
  const Case subject;
  const KnownLimit limit{{}, "no offset", {{"carried", carried}}, {}};
  const CheckUse use{"compressibility", "", {}, {}, {limit}};
  const Task task{&subject, "dsmc", "one", scene, {&use}};
  return judge_record(task, run_scene(scene), {}).front().judgement.verdict;
}

TEST(Suite, KnownLimitHasASize) {
  EXPECT_EQ(limit_of(0), Verdict::expected_fail);
  EXPECT_EQ(limit_of(0.5), Verdict::fail);
}

TEST(Suite, StopInterrupts) {
  const SyntheticCase files;
  SuiteOptions options = options_of(files);
  const std::atomic<bool> stop = true;
  options.stop = &stop;
  EXPECT_THROW(run_suite(options), Interrupted);
}

TEST(Pool, RunsEveryJobOnceAndPassesOnTheFirstException) {
  std::atomic<int> runs = 0;
  const std::vector<std::function<void()>> jobs(50, [&] { ++runs; });
  run_in_parallel(3, jobs);
  EXPECT_EQ(runs, 50);
  EXPECT_THROW(run_in_parallel(2, {[] { throw RunError("broken"); }}), RunError);
}

}  // namespace
}  // namespace sandglass::suite_test

#include "validation/check/check.hpp"

#include "validation/check/synthetic.hpp"
#include "validation/law/law.hpp"

#include <set>

#include <gtest/gtest.h>

namespace sandglass::check_test {
namespace {

using namespace synthetic;

Record small_record() {
  Record record = record_of({}, 1);
  Series& momentum = add_series(record, 0, "momentum", {"x", "y"});
  add_sample(momentum, 0, {0, 0});
  add_sample(momentum, 1, {0, 0});
  add_sample(add_series(record, 0, "momentum-scale", {}), 0, {1000});
  Series& collisions = add_series(record, 0, "collisions", {});
  add_sample(collisions, 0, {0});
  add_sample(collisions, 1, {500});
  return record;
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Registry, NamesAreUniqueAndLawsExist) {
  std::set<std::string> names;
  for (const CheckInfo& check : all_checks()) {
    EXPECT_TRUE(names.insert(check.name).second) << check.name;
    EXPECT_FALSE(check.summary.empty()) << check.name;
    EXPECT_TRUE(check.law.empty() || law::find_law(check.law).name == check.law) << check.law;
  }
}

TEST(Registry, UnknownNameSuggestsTheNearest) {
  EXPECT_NE(message_of([] { find_check("colision-rate"); }).find("did you mean 'collision-rate'"),
            std::string::npos);
}

TEST(Registry, FindsWhatARecordCanBeHeldAgainst) {
  std::vector<std::string> names;
  for (const CheckInfo* check : checks_for(small_record())) names.push_back(check->name);
  EXPECT_EQ(names, std::vector<std::string>{"momentum-conservation"});
}

TEST(RunCheck, AddsTheBudgetOfTheCase) {
  const CheckInfo& check = find_check("momentum-conservation");
  const Evidence bare = run_check(check, small_record(), {});
  const Evidence given = run_check(check, small_record(), {{}, 0.5, 0.25, "given so"});
  EXPECT_DOUBLE_EQ(given.budget.systematic, bare.budget.systematic + 0.5);
  EXPECT_DOUBLE_EQ(given.budget.resolution, 0.25);
  EXPECT_NE(given.budget.reason.find("given so"), std::string::npos);
}

TEST(RunCheck, RefusesUnknownNumbersAndMissingSeries) {
  const CheckInfo& check = find_check("haff-cooling");
  EXPECT_NE(message_of([&] {
              run_check(check, small_record(), {{{"settle", 1}}, 0, 0, ""});
            }).find("unknown parameter of check 'haff-cooling' 'settle'"),
            std::string::npos);
  EXPECT_NE(message_of([&] { run_check(check, small_record(), {}); }).find("no series 'energy'"),
            std::string::npos);
}

TEST(RunCheck, RefusesARecordWithoutReplicas) {
  Record record = small_record();
  record.replicas.clear();
  EXPECT_NE(message_of([&] { run_check(all_checks().front(), record, {}); }).find("no finished replica"),
            std::string::npos);
}

}  // namespace
}  // namespace sandglass::check_test

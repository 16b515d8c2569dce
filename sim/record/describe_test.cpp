#include "sim/record/describe.hpp"

#include "sim/record/provenance.hpp"
#include "sim/record/sample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sandglass::describe_test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::Not;

TEST(DescribeRecord, SaysWhatIsInIt) {
  const std::string text = describe_record(sample_record());
  EXPECT_THAT(text, HasSubstr("commit abc+changes"));
  EXPECT_THAT(text, HasSubstr("box 10 x 20.5 (periodic, none), 2 replicas"));
  EXPECT_THAT(text, HasSubstr("velocity-histogram [2 x 3]: 4 samples"));
  EXPECT_THAT(text, HasSubstr("trajectory: 3 frames of 3 to 5 particles"));
  EXPECT_THAT(text, HasSubstr("checkpoint: replica 3, step 77"));
  EXPECT_THAT(text, Not(HasSubstr("PLANTED")));
}

TEST(DescribeRecord, NamesAPlantedFault) {
  Record record = sample_record();
  record.provenance.planted_fault = "offset-dropped";
  record.trajectory.clear();
  EXPECT_THAT(describe_record(record), HasSubstr("PLANTED FAULT 'offset-dropped'"));
  EXPECT_THAT(describe_record(record), HasSubstr("no trajectory"));
}

TEST(Provenance, NamesVersionCommitBuildAndTime) {
  const Provenance made = current_provenance();
  EXPECT_THAT(made.program_version, MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_TRUE(made.commit == "unknown" ||
              made.commit.substr(0, 40).find_first_not_of("0123456789abcdef") == std::string::npos)
      << made.commit;
  EXPECT_THAT(made.build, HasSubstr("-ffp-contract=off"));
  EXPECT_THAT(made.created, MatchesRegex("20..-..-..T..:..:..Z"));
  EXPECT_EQ(made.planted_fault, "");
}

}  // namespace
}  // namespace sandglass::describe_test

#include "sim/base/error.hpp"
#include "sim/run/test_run_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// A box that a piston fills and nobody leaves: the run used to go on for ever without a word.

namespace sandglass::full_box_test {
namespace {

const std::string kFilling = R"(run = { seed = 1, duration = { time = 55.0 } }
domain = { dimension = 2, size = [10.0, 6.0], sides = { x = ["open", "specular"] } }
method = { preset = "event-driven", time-step = 0.5 }
initial.positions = "lattice"
species = [ { area-fraction = 0.4, restitution = 1.0 } ]
inflow = [ { side = "x-low", entry = "dispenser", number-density = 0.5, velocity = [0.2, 0.0], temperature = 0.01 } ]
)";

std::string end_of(const std::string& text) {
  try {
    run_text(text);
  } catch (const RunError& error) {
    return error.what();
  }
  return "the end";
}

TEST(FullBox, SaysWhenTimeHardlyAdvances) {
  using testing::HasSubstr;
  for (const std::string& text : {kFilling, edited(kFilling, "restitution = 1.0", "restitution = 0.9")}) {
    const std::string words = end_of(text);
    EXPECT_THAT(words, HasSubstr("time hardly advances at 4"));
    EXPECT_THAT(words, HasSubstr("the 58 particles in the box, one of them at ("));
    EXPECT_THAT(words, HasSubstr("open a side by which they leave"));
  }
}

TEST(FullBox, WithAWayOutTheRunComesToItsEnd) {
  EXPECT_EQ(end_of(edited(kFilling, R"(["open", "specular"])", R"("open")")), "the end");
}

}  // namespace
}  // namespace sandglass::full_box_test

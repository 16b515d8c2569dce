#include "sim/base/error.hpp"
#include "sim/base/test_fuzz.hpp"
#include "sim/run/run.hpp"
#include "sim/run/test_run_text.hpp"

#include <regex>

#include <gtest/gtest.h>

// Property: a scene that is read can be planned, and run as far as memory and patience go; every number of it may be one that
// nobody expects. What the reader makes of broken text is tested with it (sim/scene/fuzz_test.cpp).

namespace sandglass::scene_fuzz_test {
namespace {

const char* const kScenes[] = {
    R"(run = { seed = 1, replicas = 2, duration = { collisions-per-particle = 1.5 } }
domain = { dimension = 2, size = [20.0, 20.0] }
method = { preset = "cba", cell-size = 5.0, weight = 0.5, time-step = { collisions-per-particle = 0.1 } }
species = [ { area-fraction = 0.05, diameter = 1.0, mass = 1.0, restitution = 0.9 } ]
initial = { temperature = 1.0, velocity = [0.5, 0.0], equilibrate-collisions-per-particle = 0.5 }
observe = [ { what = "energy", every = { steps = 3 }, start = { time = 0.5 } }, { what = "pressure" },
            { what = "fields", grid = [2, 3] }, { what = "velocity-histogram", range = [-3.0, 3.0], bins = 5 } ]
output = { trajectory = { steps = 4 }, checkpoint = { steps = 5 } }
)",
    R"(run = { seed = 1, duration = { time = 1.0 } }
domain = { dimension = 2, size = [20.0, 20.0], sides = { y = "specular" } }
method = { preset = "event-driven", time-step = 0.1, collapse-guard = "contact-time", contact-time = 1e-3 }
species = [ { count = 40, diameter = 1.0, mass = 1.0, restitution = 0.9, tangential-restitution = 0.5, friction = 0.3 },
            { name = "b", count = 10, diameter = 0.5, mass = 0.2 } ]
forces.gravity = [0.0, -0.5]
wall = [ { side = "y-low", amplitude = 0.1, frequency = 1.0 }, { side = "y-high", rule = "thermal", temperature = 1.0 } ]
obstacle = [ { centre = [10.0, 10.0], radius = 2.0 } ]
initial = { positions = "random-without-overlap", temperature = 1.0, spin-temperature = 0.5 }
observe = [ { what = "energy" }, { what = "wall-force", every = { time = 0.3 } } ]
)",
    R"(run = { seed = 1, duration = { steps = 10 } }
domain = { dimension = 3, size = [8.0, 8.0, 8.0], sides = { x = "open" } }
method = { preset = "dsmc", cells = [4, 4, 4], time-step = { cell-fraction = 0.3 } }
species = [ { number-density = 0.5 } ]
inflow = [ { side = "x-low", number-density = 0.5, velocity = [1.0, 0.0, 0.0], temperature = 1.0 } ]
source = [ { rate = 5.0, count = 20, centre = [6.0, 4.0, 4.0], width = [1.0, 1.0, 1.0], velocity = [0.1, 0.0, 0.0] } ]
region = [ { low = [0.0, 0.0, 0.0], high = [4.0, 8.0, 8.0], weight = 2.0 } ]
)",
    R"(run = { duration = { steps = 10 } }
domain = { dimension = 2, size = [10.0, 10.0], sides = { y = "specular" } }
method = { preset = "hsmc", cells = [8, 8], time-step = 0.05 }
species = [ { count = 40, restitution = 0.8 } ]
forces.gravity = [0.0, -1.0]
wall = [ { side = "y-low", velocity = [1.0, 0.0] } ]
)",
    R"(run = { duration = { steps = 10 } }
domain = { dimension = 2, size = [20.0, 20.0], sides = { x = "specular", y = "specular" } }
method = { preset = "collisionless", time-step = 1.0 }
species = [ { count = 40 } ]
wall = [ { side = "y-low", rule = "thermal", temperature = 2.0 }, { side = "x-low", velocity = [0.1, 0.0] } ]
obstacle = [ { centre = [10.0, 10.0], radius = 2.0, rule = "bounce-back", probability = 0.5 } ]
)",
};

constexpr double kMostParticles = 1e5, kMostBytes = 1e8;

/// One number of the text, or two, for others.
std::string with_strange_numbers(std::string text, std::mt19937& engine) {
  static const std::regex number(R"((-?[0-9]+\.?[0-9]*(e-?[0-9]+)?)(?=[,\s\]}]))");
  static const char* const strange[] = {
      "0",     "-1",     "1e-320", "1e-300", "5e-302", "1e308",     "-1e9", "1099511627776",
      "46340", "nan",    "inf",    "1e-9",   "1e9",    "0.9999999", "1e20", "7",
      "2",     "1000.5", "1e100",  "-1e100", "1",      "3.0",       "1e-5", "1e6"};
  for (unsigned edits = 1 + engine() % 2; edits > 0; --edits) {
    const auto count = std::distance(std::sregex_iterator(text.begin(), text.end(), number), {});
    auto one = std::sregex_iterator(text.begin(), text.end(), number);
    std::advance(one, static_cast<std::ptrdiff_t>(engine() % static_cast<unsigned>(count)));
    text.replace(static_cast<std::size_t>(one->position(1)), static_cast<std::size_t>(one->length(1)),
                 strange[engine() % std::size(strange)]);
  }
  return text;
}

void expect_words(const std::exception& error) { EXPECT_STRNE(error.what(), ""); }

/// Reads, plans and, where that says that it fits, runs.
void carry_out(const std::string& text) {
  RunOptions options;
  options.stop = &stop_request.asked();
  const Deadline deadline(0.3);
  try {
    const Scene scene = read_scene_text(text, "strange.toml");
    const Plan planned = plan(scene);
    EXPECT_GE(planned.steps, 1);
    EXPECT_FALSE(std::isnan(planned.particle_moves));
    EXPECT_FALSE(std::isnan(planned.bytes_per_particle));
    if (static_cast<double>(planned.particles) > kMostParticles || planned.bytes_of_samples > kMostBytes ||
        static_cast<double>(planned.cells) > kMostParticles)
      return;
    run_scene(scene, options);
  } catch (const InputError& error) {
    expect_words(error);
  } catch (const RunError& error) {
    expect_words(error);
  } catch (const Interrupted&) {
  } catch (const std::exception& other) {
    ADD_FAILURE() << "threw something else: " << other.what() << "\n" << text;
  }
}

class SceneFuzz : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Scenes, SceneFuzz, testing::ValuesIn(kScenes),
                         [](const auto& text) { return "Scene" + std::to_string(text.index); });

TEST_P(SceneFuzz, StrangeNumbersRunOrAreRefused) {
  for (Trials trials(40); trials.next();) {
    std::mt19937 engine(trials.seed());
    const std::string text = with_strange_numbers(GetParam(), engine);
    SCOPED_TRACE(text);
    carry_out(text);
  }
}

TEST_P(SceneFuzz, TheSceneThatIsSpoiledIsGood) { EXPECT_NO_THROW(run_text(GetParam())); }

}  // namespace
}  // namespace sandglass::scene_fuzz_test

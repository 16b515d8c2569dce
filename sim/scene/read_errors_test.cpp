#include "sim/scene/test_bad_scene.hpp"

namespace sandglass::read_errors_test {
namespace {

const std::string good = R"(title = "good"
[run]
seed = 1
duration = { time = 10.0 }
[domain]
dimension = 2
size = [10.0, 10.0]
sides.y = "specular"
[[species]]
count = 20
restitution = 0.9
[method]
preset = "cba"
cell-size = 2.0
time-step = 0.1
[forces]
gravity = [0.0, -1.0]
[initial]
exact = true
[[observe]]
what = "velocity-histogram"
every = { steps = 2 }
[output]
record = "x.h5"
)";

class ReadErrors : public testing::TestWithParam<BadEdit> {};

TEST_P(ReadErrors, IsRefusedWithPlaceAndRemedy) { expect_refused(good, GetParam()); }

const std::vector<BadEdit> unknown_keys = {
    {"top", "[output]", "[outptu]", "23:2", {"unknown key 'outptu'", "did you mean 'output'?", "'initial'"}},
    {"run", "seed = 1", "sead = 1", "3:1", {"unknown key 'run.sead'", "did you mean 'seed'?"}},
    {"duration",
     "time = 10.0",
     "tim = 10.0",
     "4:14",
     {"unknown key 'run.duration.tim'", "'time'", "'steps'"}},
    {"domain",
     "dimension = 2",
     "dimension = 2\nsizes = 3",
     "7:1",
     {"'domain.sizes'", "did you mean 'size'?"}},
    {"sides", "sides.y", "sides.yy", "8:7", {"'domain.sides.yy'", "allowed: 'x' or 'y'"}},
    {"species",
     "restitution",
     "resitution",
     "11:1",
     {"unknown key 'species.resitution'; did you mean 'restitution'? allowed: 'name', 'count'"}},
    {"method", "cell-size = 2.0", "cell-size = 2.0\ncellsize = 2.0", "15:1", {"did you mean 'cell-size'?"}},
    {"underscore", "exact = true", "shear_wave = 1", "19:1", {"did you mean 'shear-wave'?"}},
    {"forces", "gravity", "gravitation", "17:1", {"'forces.gravitation'", "allowed: 'gravity'"}},
    {"initial", "exact", "exakt", "19:1", {"'initial.exakt'", "did you mean 'exact'?"}},
    {"observe",
     "every =",
     "evry =",
     "22:1",
     {"'observe.evry'", "did you mean 'every'?", "'range' or 'bins'"}},
    {"every", "{ steps = 2 }", "{ step = 2 }", "22:11", {"'observe.every.step'", "did you mean 'steps'?"}},
    {"output", "record", "recrod", "24:1", {"'output.recrod'", "did you mean 'record'?"}},
    {"nothing_near", "seed = 1", "colour = 1", "3:1", {"unknown key 'run.colour'; allowed: 'seed'"}},
};

const std::vector<BadEdit> words = {
    {"preset",
     "\"cba\"",
     "\"csba\"",
     "13:10",
     {"unknown preset 'csba'", "did you mean 'cba'?", "'dsmc-enskog'"}},
    {"side", "\"specular\"", "\"speclar\"", "8:11", {"unknown side 'speclar'", "did you mean 'specular'?"}},
    {"side_in_list",
     "\"specular\"",
     "[\"specular\", \"wall\"]",
     "8:24",
     {"unknown side 'wall'", "'periodic'"}},
    {"observer", "velocity-histogram", "velocity-histgram", "21:8", {"did you mean 'velocity-histogram'?"}},
    {"offset", "time-step = 0.1", "time-step = 0.1\noffset = 'constant'", "16:10", {"'consistent'"}},
    {"density", "time-step = 0.1", "time-step = 0.1\ndensity = 'cel'", "16:11", {"did you mean 'cell'?"}},
    {"factor",
     "time-step = 0.1",
     "time-step = 0.1\ncontact-factor = 'lokal'",
     "16:18",
     {"did you mean 'local'?"}},
    {"positions", "exact = true", "positions = 'grid'", "19:13", {"'random', 'lattice'"}},
    {"axis", "what = \"vel", "axis = 'w'\nwhat = \"vel", "21:8", {"unknown axis 'w'", "'x', 'y' or 'z'"}},
};

const std::vector<BadEdit> types = {
    {"text_for_number",
     "restitution = 0.9",
     "restitution = '0.9'",
     "11:15",
     {"must be a number, not a text"}},
    {"number_for_whole", "count = 20", "count = 2e1", "10:9", {"'species.count' must be a whole number"}},
    {"flag", "exact = true", "exact = 1", "19:9", {"must be true or false, not a whole number"}},
    {"date", "seed = 1", "seed = 2020-01-01", "3:8", {"not a date"}},
    {"vector", "[0.0, -1.0]", "-1.0", "17:11", {"must be a list of numbers"}},
    {"component", "[0.0, -1.0]", "[0.0, 'down']", "17:17", {"'forces.gravity' must be a number"}},
    {"single_species", "[[species]]", "[species]", "9:1", {"headed [[species]]"}},
    {"section",
     "[output]\nrecord = \"x.h5\"",
     "[[output]]\nids = true",
     "23:1",
     {"'output' must be a table"}},
    {"duration", "{ time = 10.0 }", "10.0", "4:12", {"'run.duration' must be a table"}},
    {"sides", "\"specular\"", "['specular']", "8:11", {"one word for both sides or a list of two"}},
    {"title", "\"good\"", "3", "1:9", {"must be a text in quotes"}},
    {"range", "what = \"vel", "range = [1, 2, 3]\nwhat = \"vel", "21:9", {"[low, high]"}},
    {"nan", "restitution = 0.9", "restitution = nan", "11:15", {"is nan; it must be a finite number"}},
    {"infinite", "[10.0, 10.0]", "[10.0, inf]", "7:15", {"'domain.size' is inf"}},
    {"negative_count", "count = 20", "count = -5", "10:9", {"is -5; it must not be negative"}},
    {"negative_seed", "seed = 1", "seed = -1", "3:8", {"'run.seed' is -1; it must not be negative"}},
    {"huge_integer", "seed = 1", "seed = 9223372036854775808", "3:27", {"not valid TOML"}},
};

const std::vector<BadEdit> combinations = {
    {"no_time_step",
     "time-step = 0.1\n",
     "",
     "12:1",
     {"missing 'method.time-step'", "collisions-per-particle"}},
    {"empty_time_step",
     "time-step = 0.1",
     "time-step = {}",
     "15:1",
     {"'method.time-step' is a table without", "{ cell-fraction = 0.5 }", "or a time"}},
    {"no_duration", "duration = { time = 10.0 }\n", "", "2:1", {"missing 'run.duration'"}},
    {"two_durations", "time = 10.0", "time = 10.0, steps = 3", "4:27", {"beside 'time'", "exactly one of"}},
    {"empty_duration", "{ time = 10.0 }", "{}", "4:12", {"exactly one of 'time', 'steps'"}},
    {"no_amount", "count = 20\n", "", "9:1", {"exactly one of 'count', 'area-fraction' (2D)"}},
    {"two_amounts", "count = 20", "count = 20\nnumber-density = 1", "11:1", {"given beside 'count'"}},
    {"volume_in_2d", "count = 20", "volume-fraction = 0.1", "10:1", {"2 dimensions: use 'area-fraction'"}},
    {"z_side_in_2d", "sides.y", "sides.z = 'periodic'\nsides.y", "8:7", {"has the axes x and y"}},
    {"cells_twice", "cell-size = 2.0", "cells = [5, 5]\ncell-size = 2.0", "15:1", {"beside 'cells'"}},
    {"random_offset", "cell-size = 2.0", "cell-size = 2.0\nrandom-offset = 1", "15:1", {"\"consistent\""}},
    {"key_of_another",
     "every =",
     "grid = [1, 2]\nevery =",
     "22:1",
     {"not used by the observer 'velocity-hist"}},
    {"no_what", "what = \"velocity-histogram\"\n", "", "20:1", {"missing 'observe.what'", "'energy'"}},
    {"no_position", "velocity-histogram", "crossings", "20:1", {"missing 'observe.position'"}},
    {"no_grid", "velocity-histogram", "fields", "20:1", {"missing 'observe.grid'"}},
    {"no_amplitude", "exact = true", "shear-wave = {}", "19:14", {"missing 'initial.shear-wave.amplitude'"}},
    {"no_size", "size = [10.0, 10.0]\n", "", "5:1", {"missing 'domain.size'"}},
    {"no_dimension", "dimension = 2\n", "", "5:1", {"missing 'domain.dimension': 2 or 3"}},
    {"key_twice", "seed = 1", "seed = 1\nseed = 2", "4:8", {"not valid TOML"}},
    {"syntax", "seed = 1", "seed = = 1", "3:8", {"not valid TOML"}},
};

INSTANTIATE_TEST_SUITE_P(UnknownKey, ReadErrors, testing::ValuesIn(unknown_keys), edit_name);
INSTANTIATE_TEST_SUITE_P(Word, ReadErrors, testing::ValuesIn(words), edit_name);
INSTANTIATE_TEST_SUITE_P(Type, ReadErrors, testing::ValuesIn(types), edit_name);
INSTANTIATE_TEST_SUITE_P(Combination, ReadErrors, testing::ValuesIn(combinations), edit_name);

TEST(ErrorsTogether, AnEmptySceneIsRefused) {
  for (const std::string text : {"", "\n", "# only a comment\n"}) try {
      read_scene_text(text, "scene.toml");
      FAIL() << "accepted";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("the scene is empty; it needs [run], [domain]"));
    }
}

TEST(ErrorsTogether, EveryErrorIsShownAtOnceInTheOrderOfTheText) {
  std::string text = good;
  for (const BadEdit& edit : {unknown_keys[4], unknown_keys[5], words[0], unknown_keys[12], types[15]})
    text = spoiled(text, edit);
  try {
    read_scene_text(text, "scene.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    std::vector<int> lines;
    for (const Diagnostic& diagnostic : error.diagnostics()) lines.push_back(diagnostic.line);
    EXPECT_THAT(lines, testing::ElementsAre(3, 8, 11, 13, 24)) << error.what();
  }
}

TEST(ErrorsTogether, EveryMissingTableIsNamed) {
  try {
    read_scene_text("title = 'x'", "scene.toml");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    for (const std::string table : {"'run'", "'domain'", "'species'", "'method'"})
      EXPECT_THAT(error.what(), testing::HasSubstr("scene.toml:1:1: error: missing " + table));
    EXPECT_EQ(error.diagnostics().size(), 4U) << error.what();
  }
}

}  // namespace
}  // namespace sandglass::read_errors_test

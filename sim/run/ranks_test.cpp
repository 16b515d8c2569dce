#include "sim/base/error.hpp"
#include "sim/base/thread_ranks.hpp"
#include "sim/run/sharing.hpp"
#include "sim/run/test_same.hpp"

#include <map>
#include <mutex>

// A scene on several ranks, threads here, against the same scene in one process.

namespace sandglass::ranks_test {
namespace {

const std::map<std::string, const char*>& scenes() {
  static const std::map<std::string, const char*> all = {{"dense", R"(
run = { seed = 1, duration = { collisions-per-particle = 6.0 }, replicas = 2 }
domain = { dimension = 2, size = [40.0, 40.0], sides = { y = "specular" } }
method = { preset = "cba", cell-size = 2.5, weight = 0.2, time-step = { collisions-per-particle = 0.1 } }
species = [{ area-fraction = 0.05, restitution = 0.9 }]
observe = [{ what = "energy", every = { steps = 5 } }, { what = "pressure", every = { steps = 5 } },
           { what = "collisions", every = { collisions-per-particle = 1.0 } }]
output = { trajectory = { steps = 20 }, checkpoint = { steps = 35 } }
)"},
                                                         {"mixture", R"(
run = { seed = 3, duration = { time = 3.0 } }
domain = { dimension = 3, size = [12.0, 10.0, 11.0], sides = { y = "specular", z = "specular" } }
method = { preset = "cba", cell-size = 2.0, weight = 0.3, time-step = 0.04 }
forces = { gravity = [0.0, 0.0, -0.4] }
species = [{ name = "a", volume-fraction = 0.04, restitution = 0.9, tangential-restitution = 0.3 },
           { name = "b", diameter = 0.6, mass = 0.3, volume-fraction = 0.02, restitution = 0.8 }]
wall = [{ side = "z-low", rule = "thermal", temperature = 1.5 }, { side = "y-low", amplitude = 0.2, frequency = 0.5 }]
obstacle = [{ centre = [6.0, 5.0, 5.0], radius = 1.5 }]
observe = [{ what = "energy", every = { time = 0.3 } }, { what = "species", every = { time = 0.3 } },
           { what = "wall-force", every = { time = 0.3 } }, { what = "spin-temperature", grid = [1, 1, 4], every = { time = 0.3 } },
           { what = "crossings", axis = "x", position = 3.0, every = { time = 0.3 } }]
output = { trajectory = { time = 1.5 }, checkpoint = { time = 1.1 }, ids = true }
)"},
                                                         {"pairs that lack", R"(
run = { seed = 5, duration = { steps = 60 } }
domain = { dimension = 2, size = [40.0, 30.0], sides = { x = "specular" } }
method = { preset = "cba-expected-pairs", lattice = "shifted", cell-size = 3.0, weight = 0.3, time-step = { cell-fraction = 0.5 } }
species = [{ area-fraction = 0.1, restitution = 0.8 }]
initial = { equilibrate-collisions-per-particle = 1.0 }
observe = [{ what = "temperature", every = { steps = 5 } }]
output = { trajectory = { steps = 30 }, checkpoint = { steps = 23 } }
)"},
                                                         {"cells on a corner", R"(
run = { seed = 5, duration = { steps = 60 } }
domain = { dimension = 2, size = [40.0, 30.0], sides = { x = "specular", y = "specular" } }
method = { preset = "cuba", lattice = "diagonal", cell-size = 3.0, weight = 0.3, time-step = { collisions-per-particle = 0.1 } }
forces = { gravity = [0.0, -0.5] }
species = [{ name = "a", area-fraction = 0.1, restitution = 0.8 }, { name = "b", area-fraction = 0.1, diameter = 0.7 }]
observe = [{ what = "centre-of-mass", every = { steps = 5 } }]
output = { trajectory = { steps = 30 }, checkpoint = { steps = 23 } }
)"},
                                                         {"idle ranks", R"(
run = { seed = 3, duration = { steps = 40 } }
domain = { dimension = 3, size = [4.0, 4.0, 4.0] }
method = { preset = "cba", cell-size = 2.0, time-step = { collisions-per-particle = 0.2 } }
species = [{ name = "a", count = 3 }, { name = "b", count = 2, diameter = 0.6, mass = 0.3 }]
observe = [{ what = "momentum", every = { steps = 5 } }, { what = "energy", every = { steps = 5 } },
           { what = "pressure", every = { steps = 5 } }, { what = "moments", every = { steps = 5 } }]
output = { trajectory = { steps = 20 }, checkpoint = { steps = 15 } }
)"},
                                                         {"outflow", R"(
run = { seed = 5, duration = { time = 8.0 } }
domain = { dimension = 3, size = [12.0, 6.0, 6.0], sides = { x = "open", z = "specular" } }
method = { preset = "collisionless", time-step = 0.5 }
species = [{ number-density = 1.0, diameter = 0.1 }]
wall = [{ side = "z-low", rule = "thermal", temperature = 2.0 }]
observe = [{ what = "temperature", every = { time = 1.0 } }, { what = "wall-force", every = { time = 1.0 } }]
output = { trajectory = { time = 4.0 }, checkpoint = { time = 3.0 }, ids = true }
)"}};
  return all;
}

/// The record of the first rank.
template <class Work>
Record on(std::size_t count, Work work) {
  Record record;
  on_ranks(count, [&](Communicator& ranks) {
    RunOptions options;
    options.ranks = &ranks;
    Record own = work(options);
    if (ranks.is_first()) record = std::move(own);
  });
  return record;
}

Record run_on(std::size_t ranks, const Scene& scene, const std::string& checkpoint = "") {
  return on(ranks, [&](RunOptions& options) {
    options.checkpoint_path = checkpoint;
    return run_scene(scene, options);
  });
}

TEST(Ranks, GiveTheRecordOfOneProcess) {
  for (const auto& [name, text] : scenes()) {
    SCOPED_TRACE(name);
    const Scene scene = read_scene_text(text, name);
    const Record alone = run_scene(scene);
    for (const std::size_t ranks : {2, 3, 7}) expect_same(run_on(ranks, scene), alone);
  }
}

/// Whatever number of ranks has written it, and goes on from it.
TEST(Ranks, GoOnFromACheckpointInAnyNumber) {
  for (const auto& [name, text] : scenes()) {
    SCOPED_TRACE(name);
    const Scene scene = read_scene_text(text, name);
    const std::string path = testing::TempDir() + "ranks_test.checkpoint.h5";
    RunOptions options;
    options.checkpoint_path = path;
    const Record whole = run_scene(scene, options);
    const State of_one = *read_record(path).state;
    run_on(3, scene, path);
    const Record checkpoint = read_record(path);
    EXPECT_EQ(checkpoint.state->memory, of_one.memory);
    EXPECT_EQ(checkpoint.state->counters, of_one.counters);
    expect_same_frame(checkpoint.state->particles, of_one.particles);
    for (const std::size_t ranks : {1, 2, 5})
      expect_same(on(ranks, [&](const RunOptions& own) { return resume(checkpoint, own); }), whole);
  }
}

Scene replicas_of(const char* preset) {
  return read_scene_text(std::string(R"(
run = { seed = 5, replicas = 5, duration = { steps = 20 } }
domain = { dimension = 2, size = [20.0, 20.0] }
species = [{ area-fraction = 0.3, restitution = 0.8 }]
observe = [{ what = "energy", every = { steps = 4 } }, { what = "collisions", every = { steps = 4 } }]
output = { trajectory = { steps = 10 } }
initial = { positions = "lattice" }
method = { time-step = 0.1, preset = ")") +
                             preset + "\" }",
                         "replicas.toml");
}

TEST(Ranks, ShareReplicasOfAnyMethod) {
  for (const char* preset : {"dsmc", "hsmc", "esmc", "event-driven"}) {
    SCOPED_TRACE(preset);
    const Scene scene = replicas_of(preset);
    const Record alone = run_scene(scene);
    for (const std::size_t ranks : {2, 5}) expect_same(run_on(ranks, scene), alone);
  }
}

std::string refusal(const Scene& scene, std::size_t ranks, bool goes_on = false) {
  try {
    sharing_of(scene, ranks, goes_on);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Sharing, TakesReplicasWhereThereAreEnoughAndNoCheckpointIsAskedFor) {
  Scene scene = replicas_of("dsmc");
  EXPECT_EQ(sharing_of(scene, 1, false), Sharing::none);
  EXPECT_EQ(sharing_of(scene, 5, false), Sharing::replicas);
  EXPECT_EQ(sharing_of(scene, 6, false), Sharing::cells);
  EXPECT_EQ(sharing_of(scene, 5, true), Sharing::cells);
  scene.output.checkpoint = Cadence{Cadence::Unit::steps, 5};
  EXPECT_EQ(sharing_of(scene, 5, false), Sharing::cells);
}

TEST(Sharing, RefusalsNameWhatForbidsIt) {
  const auto expect = [](const std::string& words, const std::string& part) {
    EXPECT_NE(words.find(part), std::string::npos) << words;
  };
  expect(refusal(replicas_of("hsmc"), 6), "excluded-volume = \"cells\"");
  expect(refusal(replicas_of("hsmc"), 6), "'run.replicas' to 6");
  expect(refusal(replicas_of("esmc"), 6), "partners = \"contact\"");
  expect(refusal(replicas_of("dsmc-bird"), 6), "pair-count = \"time-counter\"");
  expect(refusal(replicas_of("event-driven"), 6), "method 'event-driven'");
  expect(refusal(replicas_of("hsmc"), 2, true), "start it on one rank");
  Scene fitted = replicas_of("dsmc");
  std::get<DsmcOptions>(fitted.method.options).impact = ImpactDistribution::fitted;
  expect(refusal(fitted, 6), "impact = \"fitted\"");
  Scene poured = replicas_of("dsmc"), streaming = poured, weighed = poured;
  poured.sources.emplace_back();
  streaming.inflows.emplace_back();
  weighed.regions.emplace_back();
  expect(refusal(poured, 6), "a [[source]]");
  expect(refusal(streaming, 6), "an [[inflow]]");
  expect(refusal(weighed, 6), "a [[region]]");
  Scene scene = replicas_of("hsmc");
  scene.output.checkpoint = Cadence{Cadence::Unit::steps, 5};
  expect(refusal(scene, 2), "remove 'output.checkpoint'");
}

}  // namespace
}  // namespace sandglass::ranks_test

#include "sim/base/error.hpp"
#include "sim/base/test_fuzz.hpp"
#include "sim/record/scratch.hpp"
#include "sim/run/run.hpp"

#include <gtest/gtest.h>

// Property: whatever stands in the state of a checkpoint whose checksums are right, the run goes on and ends, or is refused
// in words. Nothing else happens, and nothing takes longer than the run itself.

namespace sandglass::checkpoint_fuzz_test {
namespace {

const char* const kFamilies[] = {
    // Hard disks: two species, rough, guarded, between a vibrating floor and a wall that draws.
    R"(
method = { preset = "event-driven", time-step = 0.1, collapse-guard = "contact-time", contact-time = 1e-4 }
domain = { dimension = 2, size = [12.0, 12.0], sides = { y = "specular" } }
forces.gravity = [0.0, -0.1]
initial.positions = "lattice"
species = [ { name = "a", count = 25, restitution = 0.9, tangential-restitution = 0.5 },
            { name = "b", count = 10, diameter = 0.5, mass = 0.3 } ]
wall = [ { side = "y-low", amplitude = 0.1, frequency = 1.0 }, { side = "y-high", rule = "thermal", temperature = 1.0 } ]
observe = [ { what = "energy" }, { what = "wall-force" }, { what = "species" }, { what = "impact-parameter", bins = 4 } ]
)",
    // Hard spheres.
    R"(
method = { preset = "event-driven", time-step = 0.1 }
domain = { dimension = 3, size = [6.0, 6.0, 6.0] }
initial.positions = "lattice"
species = [ { count = 30, restitution = 0.9 } ]
observe = [ { what = "pressure" }, { what = "crossings", axis = "x", position = 3.0, bins = 4 } ]
)",
    // A stream from a dispenser to a side that turns some back; those who come by the other way wait for room.
    R"(
method = { preset = "event-driven", time-step = 0.1 }
domain = { dimension = 2, size = [30.0, 10.0], sides = { x = "open" } }
initial.positions = "lattice"
species = [ { count = 40 } ]
inflow = [ { side = "x-low", entry = "dispenser", number-density = 0.3, velocity = [1.0, 0.0], temperature = 0.1 } ]
outflow = [ { side = "x-high", velocity = [1.0, 0.0], temperature = 0.1 } ]
)",
    R"(
method = { preset = "event-driven", time-step = 0.1 }
domain = { dimension = 2, size = [12.0, 12.0], sides = { x = "open" } }
initial.positions = "lattice"
species = [ { count = 30 } ]
inflow = [ { side = "x-low", number-density = 0.3, velocity = [1.0, 0.0], temperature = 1.0 } ]
source = [ { rate = 5.0, centre = [6.0, 6.0], width = [8.0, 8.0] } ]
)",
    R"(
method = { preset = "cba-corrected", cells = [6, 6], time-step = 0.05 }
domain = { dimension = 2, size = [40.0, 40.0] }
species = [ { count = 200, restitution = 0.9 } ]
observe = [ { what = "pressure" }, { what = "moments" }, { what = "fields", grid = [2, 2] } ]
)",
    R"(
method = { preset = "dsmc", pair-count = "time-counter", cells = [6, 6], time-step = { collisions-per-particle = 0.1 } }
domain = { dimension = 2, size = [40.0, 40.0] }
species = [ { count = 200, restitution = 0.9 } ]
)",
    R"(
method = { preset = "hsmc", cells = [27, 27], time-step = 0.05 }
domain = { dimension = 2, size = [40.0, 40.0], sides = { y = "specular" } }
forces.gravity = [0.0, -1.0]
species = [ { count = 60, restitution = 0.9 } ]
)",
    R"(
method = { preset = "esmc", cells = [40, 40], time-step = 0.05 }
domain = { dimension = 2, size = [40.0, 40.0] }
species = [ { count = 60 } ]
)",
    R"(
method = { preset = "dsmc", cells = [6, 6], time-step = 0.05 }
domain = { dimension = 2, size = [40.0, 40.0], sides = { x = "open" } }
species = [ { count = 200 } ]
region = [ { low = [0.0, 0.0], high = [20.0, 40.0], weight = 2.0 } ]
inflow = [ { side = "x-low", number-density = 0.2, velocity = [1.0, 0.0], temperature = 1.0 } ]
observe = [ { what = "cloning" } ]
)",
    R"(
method = { preset = "collisionless", time-step = 0.05 }
domain = { dimension = 2, size = [40.0, 40.0], sides = { y = "specular" } }
wall = [ { side = "y-low", velocity = [0.0, 0.1] }, { side = "y-high", rule = "thermal", temperature = 1.0 } ]
species = [ { count = 100 } ]
)",
};

/// With a state in the middle of the run.
Record checkpoint_of(const char* text) {
  const ScratchFolder folder;
  RunOptions options;
  options.checkpoint_path = folder / "run.checkpoint.h5";
  run_scene(read_scene_text(std::string(text) + "run.duration = { steps = 12 }\n"
                                                "[output]\nids = true\ncheckpoint = { steps = 8 }\n",
                            "fuzz.toml"),
            options);
  return read_record(options.checkpoint_path);
}

double& pick(std::vector<double>& numbers, std::mt19937& engine) {
  return numbers[engine() % numbers.size()];
}

void spoil_column(NamedColumn& column, std::mt19937& engine) {
  std::visit(
      [&](auto& values) {
        if (values.empty()) return;
        auto& value = values[engine() % values.size()];
        using Value = std::remove_reference_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, double>)
          value = hostile_number(engine, value);
        else
          value = static_cast<Value>(engine());
      },
      column.numbers);
}

void spoil_memory(State& state, std::mt19937& engine) {
  auto entry = std::next(state.memory.begin(), static_cast<std::ptrdiff_t>(engine() % state.memory.size()));
  std::vector<double>& numbers = entry->second;
  switch (engine() % 12) {
    case 0:
      state.memory.erase(entry);
      return;
    case 1:
      if (!numbers.empty()) numbers.pop_back();
      return;
    case 2:
      numbers.push_back(hostile_number(engine));
      return;
    case 3:
      numbers.clear();
      return;
    default:
      if (!numbers.empty()) {
        double& number = pick(numbers, engine);
        number = hostile_number(engine, number);
      }
  }
}

void spoil(State& state, std::mt19937& engine) {
  Frame& frame = state.particles;
  switch (engine() % 8) {
    case 0:
      pick(frame.position, engine) = hostile_number(engine, frame.position.front());
      return;
    case 1:
      pick(frame.velocity, engine) = hostile_number(engine, frame.velocity.front());
      return;
    case 2:
      if (engine() % 2 == 0)
        state.time = hostile_number(engine, state.time);
      else
        state.step = engine() % 2 == 0 ? std::uint64_t{1} << 40 : ~std::uint64_t{0};
      return;
    case 3: {
      Columns columns;
      for (NamedColumn column : frame.columns.all()) {
        if (engine() % 8 == 0) continue;
        spoil_column(column, engine);
        columns.set(column);
      }
      frame.columns = columns;
      return;
    }
    default:
      spoil_memory(state, engine);
  }
}

void go_on(const Record& checkpoint) {
  RunOptions options;
  options.stop = &stop_request.asked();
  const Deadline deadline(10);
  try {
    resume(checkpoint, options);
  } catch (const InputError& error) {
    EXPECT_STRNE(error.what(), "");
  } catch (const RunError& error) {
    EXPECT_STRNE(error.what(), "");
  } catch (const std::exception& other) {
    ADD_FAILURE() << "threw something else: " << other.what();
  }
}

class CheckpointFuzz : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Families, CheckpointFuzz, testing::ValuesIn(kFamilies),
                         [](const auto& text) { return "Scene" + std::to_string(text.index); });

TEST_P(CheckpointFuzz, ASpoiledStateIsGoneOnFromOrRefused) {
  const Record good = checkpoint_of(GetParam());
  for (Trials trials(300); trials.next();) {
    std::mt19937 engine(trials.seed());
    Record spoiled = good;
    for (unsigned edits = 1 + engine() % 2; edits > 0; --edits) spoil(*spoiled.state, engine);
    go_on(spoiled);
  }
}

/// Each of the numbers of the state in turn is one that leads beyond any list.
TEST_P(CheckpointFuzz, NoNumberOfTheMemoryLeadsAstray) {
  const Record good = checkpoint_of(GetParam());
  for (const auto& [name, numbers] : good.state->memory)
    for (const double strange : {std::nan(""), 1e308, -1e9, 0x1p40}) {
      if (numbers.empty()) continue;
      Record spoiled = good;
      spoiled.state->memory.at(name)[numbers.size() / 2] = strange;
      SCOPED_TRACE(name + " " + std::to_string(strange));
      go_on(spoiled);
      if (HasFailure()) return;
    }
}

TEST_P(CheckpointFuzz, TheStateThatIsSpoiledIsGood) { EXPECT_NO_THROW(resume(checkpoint_of(GetParam()))); }

}  // namespace
}  // namespace sandglass::checkpoint_fuzz_test

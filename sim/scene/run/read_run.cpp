#include "sim/scene/read_sections.hpp"

namespace sandglass {

void read_run(Table& table, Run& run) {
  table.read("seed", run.seed);
  table.read("replicas", run.replicas);
  if (!table.has("duration"))
    table.report_missing("duration", "say how long to run, for example duration = { time = 10.0 }");
  if (std::optional<Table> duration = table.table("duration")) run.duration = read_duration(*duration);
  table.finish();
}

void read_output(Table& table, Output& output) {
  table.read("record", output.record);
  read_cadence(table, "trajectory", output.trajectory);
  table.read("ids", output.ids);
  read_cadence(table, "checkpoint", output.checkpoint);
  table.read("event-trace", output.event_trace);
  table.finish();
}

}  // namespace sandglass

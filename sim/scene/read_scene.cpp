#include "sim/scene/read_sections.hpp"
#include "sim/scene/rules.hpp"
#include "sim/scene/scene_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace sandglass {

namespace {
template <class Section>
void read_section(Table& root, const std::string& key, void (*read)(Table&, Section&), Section& section) {
  if (std::optional<Table> table = root.table(key)) read(*table, section);
}

void report_missing_tables(Table& root) {
  for (const std::string key : {"run", "domain", "method"})
    if (!root.has(key)) root.report_missing(key, "every scene needs a table headed [" + key + "]");
  if (!root.has("species"))
    root.report_missing("species", "describe the particles in a table headed [[species]]");
}

/// Whether positions = "given"; where the word is wrong, whether there are particles.
bool read_initial_section(Table& root, Initial& initial) {
  bool given = false;
  if (std::optional<Table> table = root.table("initial")) given = read_initial(*table, initial);
  return root.clean("initial.positions") ? given : root.has("particle");
}

/// What tables may name; nullptr when the species are not known.
const std::vector<Species>* known_species(Table& root, const Scene& scene) {
  return root.clean("species") ? &scene.species : nullptr;
}

void read_particles(Table& root, bool given, int dimension, Scene& scene) {
  if (!given) {
    root.refuse("particle", "is used with positions = \"given\" in [initial] only");
    return;
  }
  for (Table& table : root.tables("particle"))
    read_particle(table, dimension, known_species(root, scene), scene.given.emplace_back());
  if (scene.given.empty() && root.clean("particle"))
    root.report_missing("particle", "positions = \"given\" needs a table headed [[particle]] for each one");
}

Scene read_tables(Table& root, Diagnostics& diagnostics) {
  Scene scene;
  report_missing_tables(root);
  root.read("title", scene.title);
  read_section(root, "run", read_run, scene.run);
  std::vector<double> proportions;
  if (std::optional<Table> table = root.table("domain")) read_domain(*table, scene.domain, proportions);
  const bool boxed = proportions.empty();
  const bool given = read_initial_section(root, scene.initial);
  const int dimension = root.clean("domain.dimension") ? scene.domain.dimension : 0;
  for (Table& table : root.tables("species")) read_species(table, dimension, given, boxed, scene.species);
  read_section(root, "method", read_method, scene.method);
  read_section(root, "forces", read_forces, scene.gravity);
  for (Table& table : root.tables("wall")) read_wall(table, scene.walls.emplace_back());
  for (Table& table : root.tables("obstacle")) read_obstacle(table, scene.obstacles.emplace_back());
  for (Table& table : root.tables("source")) read_source(table, scene.sources.emplace_back());
  for (Table& table : root.tables("inflow"))
    read_inflow(table, known_species(root, scene), scene.inflows.emplace_back());
  for (Table& table : root.tables("region")) read_region(table, scene.regions.emplace_back());
  for (Table& table : root.tables("outflow")) read_outflow(table, scene.outflows.emplace_back());
  read_particles(root, given, dimension, scene);
  for (Table& table : root.tables("observe")) read_observe(table, scene.observe.emplace_back());
  read_section(root, "output", read_output, scene.output);
  if (!boxed) fit_box(proportions, scene, diagnostics);
  root.finish();
  return scene;
}

/// Gravity of no strength is no gravity: nothing of it is then compiled into the run.
void drop_zero_gravity(std::vector<double>& gravity) {
  if (std::all_of(gravity.begin(), gravity.end(), [](double component) { return component == 0; }))
    gravity.clear();
}
}  // namespace

Scene read_scene_text(const std::string& text, const std::string& file_name) {
  const Node document = parse_document(text, file_name);
  Diagnostics diagnostics(file_name, document);
  if (document.items.empty()) {
    diagnostics.report(
        "", "the scene is empty; it needs [run], [domain], [[species]] and [method]: see docs/scene.md");
    diagnostics.raise();
  }
  Table root(document, "", diagnostics);
  Scene scene = read_tables(root, diagnostics);
  check_rules(scene, diagnostics);
  diagnostics.raise();
  drop_zero_gravity(scene.gravity);
  return scene;
}

std::string scene_file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError("cannot read the scene '" + path + "': " + std::strerror(errno));
  if (std::filesystem::is_directory(path))
    throw InputError("the scene '" + path + "' is a folder; name a file");
  return {std::istreambuf_iterator<char>(file), {}};
}

Scene read_scene_file(const std::string& path) { return read_scene_text(scene_file_text(path), path); }

}  // namespace sandglass

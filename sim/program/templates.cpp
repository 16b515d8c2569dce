#include "sim/program/templates.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"
#include "sim/program/folders.hpp"
#include "sim/program/options.hpp"
#include "sim/record/output_files.hpp"
#include "sim/scene/scene.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

namespace sandglass::program {

namespace {
Template find_template(const std::string& name) {
  std::vector<std::string> names;
  for (const Template& one : templates()) {
    if (one.name == name) return one;
    names.push_back(one.name);
  }
  throw InputError(unknown_word("template", name, names));
}
}  // namespace

std::vector<Template> templates() {
  std::vector<Template> all;
  for (const auto& entry : std::filesystem::directory_iterator(home() + "/docs/examples"))
    if (entry.path().extension() == ".toml")
      all.push_back({entry.path().stem().string(), read_scene_file(entry.path().string()).title,
                     entry.path().string()});
  std::ranges::sort(all, {}, &Template::name);
  return all;
}

int new_scene(const Options& options) {
  const Template chosen = find_template(options.subject);
  const std::string path = options.output.empty() ? chosen.name + ".toml" : options.output;
  OutputFiles outputs({chosen.path});
  outputs.claim({path, options.overwrite ? Existing::replace : Existing::keep,
                 "use --overwrite to replace it, or another file with --output"});
  std::error_code error;
  std::filesystem::copy_file(chosen.path, path, std::filesystem::copy_options::overwrite_existing, error);
  if (error) throw RunError("cannot write '" + path + "': " + error.message());
  if (!options.quiet) fmt::print("{}: {}\nnext: sandglass plan {}\n", path, chosen.summary, path);
  return all_well;
}

}  // namespace sandglass::program

#include "sim/record/export.hpp"

#include "sim/program/options.hpp"
#include "sim/record/output_files.hpp"
#include "sim/scene/scene.hpp"

#include <filesystem>

#include <fmt/format.h>

namespace sandglass::program {

namespace {
std::string extension_of(const std::string& format) {
  if (format == "vtp") return ".pvd";
  return format == "mdanalysis" ? ".h5md" : "." + format;
}
}  // namespace

int export_files(const Options& options) {
  const Record record = read_record(options.subject);
  const Scene scene = read_scene_text(record.scene, options.subject);
  const std::string path =
      options.output.empty()
          ? std::filesystem::path(options.subject).replace_extension(extension_of(options.format)).string()
          : options.output;
  const Existing existing = options.overwrite ? Existing::replace : Existing::keep;
  OutputFiles outputs({options.subject});
  for (const std::string& file : export_paths(record, options.format, path))
    outputs.claim({file, existing, "use --overwrite to replace it, or another file with --output"});
  for (const std::string& file :
       export_record(record, options.format, path, {scene.species.front().diameter}))
    fmt::print("{}\n", file);
  return all_well;
}

}  // namespace sandglass::program

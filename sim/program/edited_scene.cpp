#include "sim/program/edited_scene.hpp"

#include "sim/base/error.hpp"
#include "sim/scene/scene_file.hpp"
#include "validation/suite/overlay.hpp"

namespace sandglass::program {

namespace {
/// A value that is no TOML is a word: shells take quotes away.
Override override_of(const std::string& setting) {
  const std::size_t equals = setting.find('=');
  const std::string file = "--set " + setting;
  if (equals == std::string::npos || equals == 0 || equals + 1 == setting.size())
    throw InputError("'" + file + "': write key=value, for example --set species.restitution=0.9");
  try {
    return {parse_document(setting, file), file};
  } catch (const InputError&) {
    const std::string word = setting.substr(equals + 1);
    if (word.find_first_of("\"'[]{}\n") != std::string::npos) throw;
    return {parse_document(setting.substr(0, equals) + " = \"" + word + "\"", file), file};
  }
}
}  // namespace

Scene read_edited_scene(const std::string& path, const std::vector<std::string>& settings) {
  if (settings.empty()) return read_scene_file(path);
  return edited_scene(scene_file_text(path), path, settings);
}

std::vector<Override> overrides_of(const std::vector<std::string>& settings) {
  std::vector<Override> overrides;
  for (const std::string& setting : settings) overrides.push_back(override_of(setting));
  return overrides;
}

Scene edited_scene(const std::string& text, const std::string& name,
                   const std::vector<std::string>& settings) {
  const std::vector<Override> overrides = overrides_of(settings);
  std::vector<const Override*> layers;
  for (const Override& one : overrides) layers.push_back(&one);
  return lay_over(parse_document(text, name), name, layers);
}

}  // namespace sandglass::program

#include "sim/program/completion.hpp"

#include "sim/base/error.hpp"
#include "sim/base/spelling.hpp"

#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sandglass::program {

namespace {
/// What follows a command, as an argument of compgen; whatever `sandglass list` names is asked for when it is wanted.
const std::map<std::string, std::string>& followers() {
  const std::string names = R"~(-W "$(sandglass list {} 2>/dev/null | cut -d ' ' -f 1)")~";
  const auto named = [&](const char* what) { return fmt::format(fmt::runtime(names), what); };
  static const std::map<std::string, std::string> all = {
      {"new", named("templates")},
      {"run", "-f -X '!*.toml'"},
      {"plan", "-f -X '!*.toml'"},
      {"resume", "-f -X '!*.checkpoint.h5'"},
      {"check", "-f -X '!*.h5'"},
      {"export", "-f -X '!*.h5'"},
      {"validate", named("cases")},
      {"law", named("laws")},
      {"list", R"(-W "templates methods observers cases laws checks claims mutations")"},
      {"completion", R"(-W "bash zsh")"},
  };
  return all;
}

std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> words;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) words.push_back(fmt::format("--{}", name));
  return words;
}
}  // namespace

std::string completion_script(const CLI::App& app, const std::string& shell) {
  const std::vector<std::string> shells{"bash", "zsh"};
  if (shell != "bash" && shell != "zsh") throw InputError(unknown_word("shell", shell, shells));
  std::vector<std::string> commands;
  std::string cases;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    const std::string name = command->get_name();
    commands.push_back(name);
    const auto follower = followers().find(name);
    cases += fmt::format("    {}) options='{}'; words=({}) ;;\n", name, fmt::join(options_of(*command), " "),
                         follower == followers().end() ? "-W ''" : follower->second);
  }
  return fmt::format(R"({}_sandglass() {{
  local current=${{COMP_WORDS[COMP_CWORD]}} options='' words=(-f)
  if ((COMP_CWORD == 1)); then
    COMPREPLY=($(compgen -W '{} --help --version' -- "$current"))
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  if [[ $current == -* ]]; then words=(-W "$options"); fi
  COMPREPLY=($(compgen "${{words[@]}}" -- "$current"))
}}
complete -o filenames -o bashdefault -F _sandglass sandglass
)",
                     shell == "zsh" ? "autoload -U +X bashcompinit && bashcompinit\n" : "",
                     fmt::join(commands, " "), cases);
}

}  // namespace sandglass::program

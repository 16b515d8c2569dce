# shellcheck shell=bash
# Shared by ci/validate and ci/test: steps with a log, exact complaints, packages, Python, build.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$top/build/release
logs=$top/build/log
# The exit codes of the program, kept by the scripts: 0 all well, 1 something blocks, and these two.
bad_input=2
broke=3

# step NAME TEXT COMMAND...: one line on the screen, the output in build/log/NAME.log, its end upon failure.
step() {
  local name=$1 text=$2 started=$SECONDS status=0
  shift 2
  printf '%s ... ' "$text"
  "$@" >"$logs/$name.log" 2>&1 </dev/null || status=$?
  if ((status == 0)); then
    printf 'ok, %d s\n' $((SECONDS - started))
  else
    printf 'failed with exit code %d after %d s; the end of its log:\n' "$status" $((SECONDS - started))
    tail -n 40 "$logs/$name.log" | sed 's/^/  | /'
    printf '  whole log: %s\n' "$logs/$name.log"
  fi
  return "$status"
}

refuse() {
  printf 'error: %s\n' "$*" >&2
  exit "$bad_input"
}

edit_distance() {
  local a=$1 b=$2 i j diagonal above cost
  local -a row
  for ((j = 0; j <= ${#b}; j++)); do row[j]=$j; done
  for ((i = 1; i <= ${#a}; i++)); do
    diagonal=${row[0]}
    row[0]=$i
    for ((j = 1; j <= ${#b}; j++)); do
      above=${row[j]}
      cost=$((diagonal + 1))
      if [[ ${a:i-1:1} == "${b:j-1:1}" ]]; then cost=$diagonal; fi
      row[j]=$((above + 1 < row[j - 1] + 1 ? above + 1 : row[j - 1] + 1))
      row[j]=$((cost < row[j] ? cost : row[j]))
      diagonal=$above
    done
  done
  printf '%d\n' "${row[${#b}]}"
}

# refuse_word KIND WORD ALLOWED...: names the nearest spelling and every allowed word, exits 2.
refuse_word() {
  local kind=$1 word=$2 hint='' candidate distance
  local least=$((${#word} / 3 > 2 ? ${#word} / 3 : 2))
  shift 2
  for candidate in "$@"; do
    distance=$(edit_distance "$word" "$candidate")
    if ((distance <= least)); then
      hint="; did you mean '$candidate'?"
      least=$((distance - 1))
    fi
  done
  refuse "unknown $kind '$word'$hint (allowed: $*)"
}

# require_word KIND WORD ALLOWED...
require_word() {
  local candidate
  for candidate in "${@:3}"; do
    if [[ $candidate == "$2" ]]; then return; fi
  done
  refuse_word "$@"
}

packages_of() {
  local group
  for group in "$@"; do awk -v group="$group" '$1 == group { print $2 }' "$top/ci/packages.txt"; done
}

missing_packages() {
  local -a wanted
  mapfile -t wanted < <(packages_of "$@")
  if ! command -v dpkg-query >/dev/null; then return; fi # not Debian: CMake names what it cannot find
  dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null |
    awk -v wanted="${wanted[*]}" '
      $2 == "installed" { have[$1] }
      END { n = split(wanted, name, " ")
            for (i = 1; i <= n; i++) if (!(name[i] in have)) print name[i] }' || true
}

as_root() {
  if ((EUID == 0)); then "$@"; else sudo "$@"; fi
}

apt() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -y -q "$@"
}

update_package_lists() {
  apt -o APT::Update::Error-Mode=any update || { sleep 5 && apt -o APT::Update::Error-Mode=any update; }
}

# install_packages MAY_INSTALL GROUP...: installs what is missing; nothing missing, no call of apt.
install_packages() {
  local may_install=$1
  local -a missing
  mapfile -t missing < <(missing_packages "${@:2}")
  if ((${#missing[@]} == 0)); then return; fi
  local remedy="as root: apt-get install --no-install-recommends ${missing[*]}"
  if [[ $may_install == no ]]; then refuse "missing packages, and --no-install was given; $remedy"; fi
  if ((EUID != 0)) && ! command -v sudo >/dev/null; then
    refuse "missing packages, and no sudo; $remedy"
  fi
  printf 'missing packages: %s\n' "${missing[*]}"
  as_root true # sudo asks for its password here, where it can be seen
  step packages-update 'updating package lists' update_package_lists ||
    printf 'note: package lists could not be updated; trying with those that are here\n'
  step packages-install "installing ${#missing[@]} packages" \
    apt install --no-install-recommends "${missing[@]}" || exit "$broke"
}

# find_python MODULE...: prints the first interpreter, 3.11 or newer, that can import them all.
find_python() {
  local candidate modules=$*
  local environment=${VIRTUAL_ENV:+$VIRTUAL_ENV/bin/python3}
  for candidate in "${SANDGLASS_PYTHON:-}" "$environment" python3 /usr/bin/python3; do
    if [[ -n $candidate ]] && "$candidate" -c "import tomllib, ${modules// /, }" >/dev/null 2>&1; then
      command -v "$candidate"
      return
    fi
  done
  return 1
}

# prepare MAY_INSTALL "PYTHON_GROUP..." GROUP...: installs what is missing and sets `python`, an interpreter
# with every module of the Python groups. Someone's own Python that has them needs no package.
prepare() {
  local may_install=$1 groups=("${@:3}")
  local -a python_groups modules
  mkdir -p "$logs" || refuse "cannot write to $logs; remedy: a copy of the repository that you may write to"
  read -ra python_groups <<<"$2"
  mapfile -t modules < <(packages_of "${python_groups[@]}" | sed -n 's/^python3-//p')
  python=$(find_python "${modules[@]}") || groups+=("${python_groups[@]}")
  install_packages "$may_install" "${groups[@]}"
  python=${python:-$(find_python "${modules[@]}")} ||
    refuse "no Python 3.11 can import ${modules[*]}; remedy: set SANDGLASS_PYTHON to one that can, or install" \
      "$(packages_of "${python_groups[@]}" | paste -sd ' ')"
}

# Warnings are errors in the build of the scripts; once configured, ninja runs CMake again when it must.
configure() {
  cmake -S "$top" --fresh --preset release -DSANDGLASS_WARNINGS_AS_ERRORS=ON
}

is_configured() {
  local cache=$build/CMakeCache.txt
  [[ -f $build/build.ninja ]] && grep -qx 'SANDGLASS_WARNINGS_AS_ERRORS:BOOL=ON' "$cache" &&
    grep -qx "CMAKE_HOME_DIRECTORY:INTERNAL=$top" "$cache"
}

# shellcheck shell=bash
# Says what is being done and installs what is missing; sourced by ./demo, ./test and ./bench.

# Prints a heading on a line of its own.
say() { printf '\n== %s\n' "$*"; }

# Stops with a message.
give_up() {
  printf '\n%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# Lists the packages of the given sets (build, test, bench).
packages_of() {
  local set
  for set in "$@"; do
    sed -n "s/^$set: *//p" scripts/debian_packages.txt
  done | tr ' ' '\n'
}

# Lists those of its arguments that are not installed.
missing_of() {
  local package
  for package in "$@"; do
    dpkg-query --show --showformat='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || echo "$package"
  done
}

# Runs a command as root: as it is in a container, with sudo for a user.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  else
    sudo "$@"
  fi
}

# Installs the packages of the given sets that are missing; asks the network for nothing when none is.
install_packages() {
  command -v dpkg-query >/dev/null || give_up "this script installs Debian packages; elsewhere see docs/develop/building.md"
  local wanted missing
  wanted=$(packages_of "$@")
  # Debian's nodejs and npm conflict with a newer Node.js from elsewhere: take whatever is there.
  command -v node >/dev/null || wanted="$wanted nodejs"
  command -v npm >/dev/null || wanted="$wanted npm"
  missing=$(missing_of $wanted)
  if [ -z "$missing" ]; then
    echo "Every package that is needed is installed."
    return
  fi
  echo "Installing:" $missing
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    give_up "install these packages as root, then run this again:" $missing
  fi
  as_root apt-get update -q || give_up "the package lists could not be fetched; is the network there?"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $missing ||
    give_up "the packages could not be installed"
}

# Configures a preset of CMakePresets.json, showing the log only when that fails: configure PRESET [cmake options].
configure() {
  local preset=$1
  shift
  # Debian's Python packages belong to Debian's Python, whatever other Python comes first in PATH.
  cmake --preset "$preset" -D FIBERFATE_PRECOMPILE=ON -D Python3_EXECUTABLE=/usr/bin/python3 "$@" >"build/configure_$preset.log" 2>&1 || {
    cat "build/configure_$preset.log"
    return 1
  }
}

# Configures and builds a preset: build_preset PRESET [cmake options].
build_preset() {
  configure "$@" && cmake --build --preset "$1"
}

# Where ccache is installed, a clone in another folder compiles to the same objects.
export CCACHE_BASEDIR="$PWD" CCACHE_NOHASHDIR=true

mkdir -p build

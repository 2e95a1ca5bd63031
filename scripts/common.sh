# Shared by scripts/run and scripts/test: the machine's packages, the configured and built tree.
# Sourced, not run. After `prepare`, $build holds the build folder of the chosen preset.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${COVARIA_PRESET:-release}
build=$root/build/$preset

say() { printf 'covaria: %s\n' "$*" >&2; }

install_missing_packages() {
    command -v dpkg-query >/dev/null || { say "not a Debian system: install the packages of scripts/packages.txt yourself"; return; }
    local wanted missing
    wanted=$(grep -v '^#' "$root/scripts/packages.txt")
    missing=$(for package in $wanted; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || echo "$package"
    done)
    [ -z "$missing" ] && return
    say "installing missing packages:" $missing
    local sudo=
    if [ "$(id -u)" -ne 0 ]; then
        command -v sudo >/dev/null || { say "run as root or install sudo, to install:" $missing; exit 1; }
        sudo=sudo
    fi
    $sudo apt-get update -qq
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
}

# prepare TARGET ...: everything needed to run those targets.
prepare() {
    install_missing_packages
    cd "$root"
    if [ ! -f "$build/build.ninja" ]; then
        say "configuring ($preset)"
        cmake --preset "$preset" >"$root/.configure.log" 2>&1 || { cat "$root/.configure.log" >&2; exit 1; }
        mv "$root/.configure.log" "$build/configure.log"
    fi
    say "building ($preset)"
    local log=$build/build.log
    cmake --build --preset "$preset" --target "$@" >"$log" 2>&1 || { tail -n 60 "$log" >&2; say "the build failed; all of it is in $log"; exit 1; }
}

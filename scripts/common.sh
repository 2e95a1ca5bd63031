# Shared by the scripts beside it: the machine's packages, the configured and built tree.
# Sourced, not run. After `prepare`, $build holds the build folder of the chosen preset.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${COVARIA_PRESET:-release}
build=$root/build/$preset

say() { printf 'covaria: %s\n' "$*" >&2; }

# install_missing_packages [FILE]: those of a list, as a rule of scripts/packages.txt.
install_missing_packages() {
    local list=$root/${1:-scripts/packages.txt} missing
    command -v dpkg-query >/dev/null || { say "not a Debian system: install the packages of $list yourself"; return; }
    missing=$(comm -23 <(grep -v "^#" "$list" | sort) \
        <(dpkg-query -W -f='${db:Status-Status} ${Package}\n' | sed -n 's/^installed //p' | sort))
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

# Reads ninja's lines "[done/all seconds] what": on a terminal one line that says how far it is and how long it will
# take, elsewhere a line every tenth; all of it into the file that is named.
show_progress() {
    awk -v log_file="$1" -v terminal="$([ -t 2 ] && echo 1 || echo 0)" '
        { print > log_file; fflush(log_file) }
        match($0, /^\[[0-9]+\/[0-9]+ +[0-9.]+\]/) {
            split(substr($0, 2, RLENGTH - 2), part, /[\/ ]+/)
            finished = part[1]; all = part[2]; seconds = part[3]
            left = finished > 0 ? seconds / finished * (all - finished) : 0
            text = sprintf("covaria: %d of %d steps, %d:%02d so far, about %d:%02d left", finished, all,
                           seconds / 60, seconds % 60, left / 60, left % 60)
            if (terminal) printf "\r%s   ", text > "/dev/stderr"
            else if (all >= 10 && int(10 * finished / all) > tenth) { tenth = int(10 * finished / all); print text > "/dev/stderr" }
            shown = 1
        }
        END { if (terminal && shown) print "" > "/dev/stderr" }'
}

# prepare TARGET ...: everything needed to run those targets.
prepare() {
    install_missing_packages
    cd "$root"
    if [ ! -f "$build/build.ninja" ]; then
        say "configuring ($preset)"
        mkdir -p "$build"
        cmake --preset "$preset" >"$build/configure.log" 2>&1 || { cat "$build/configure.log" >&2; exit 1; }
    fi
    say "building ($preset)"
    NINJA_STATUS='[%f/%t %e] ' cmake --build --preset "$preset" --target "$@" 2>&1 | show_progress "$build/build.log" ||
        { grep -E -A 20 'error|FAILED' "$build/build.log" | head -n 60 >&2; say "the build failed; all of it is in $build/build.log"; exit 1; }
}

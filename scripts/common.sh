# Shared by the scripts beside it: the machine's packages, the configured and built tree.
# Sourced, not run. After `prepare`, $build holds the build folder of the chosen preset.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${COVARIA_PRESET:-release}
build=$root/build/$preset

say() { printf 'covaria: %s\n' "$*" >&2; }

# install_missing_packages [FILE]: installs the missing ones of a list, as a rule of scripts/packages.txt.
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

# Seconds that a step took in a build from bare (scripts/build-times.txt, written by `scripts/build-times`), by the last
# word of what ninja calls it; two seconds where that is not known.
declare -A step_seconds=()
read_step_seconds() {
    local seconds name
    while read -r seconds name; do step_seconds[$name]=$seconds; done <"$root/scripts/build-times.txt"
}

# Hundredths of a second for each of ninja's lines "[done/all seconds] name" that it is given, added up.
weight_of() {
    local line all=0 seconds
    while IFS= read -r line; do
        [[ $line =~ ^\[[0-9]+/[0-9]+ ]] || continue
        seconds=${step_seconds[${line##* }]:-2.00}
        all=$((all + 10#${seconds/./}))
    done
    echo "$all"
}

# The lines that ninja would print in a build of TARGETs. A dry run ends at the rule that makes build.ninja anew, which is
# always due because source lists are globbed; the copy that is read here has no such rule.
steps_to_build() {  # TARGET ...
    sed '/^build build\.ninja:/,/^$/d' "$build/build.ninja" >"$build/steps.ninja"
    ninja -C "$build" -f steps.ninja -n "$@"
}

# Reads ninja's lines as they come: on a terminal one line that says how far it is and how long it will take, elsewhere a
# line every tenth; all of it into the file that is named. WEIGHT: of all steps, as weight_of says.
show_progress() {  # LOG WEIGHT
    local line weight=0 tenth=0 all=$2 left text began=$SECONDS passed
    : >"$1"
    while IFS= read -r line; do
        printf '%s\n' "$line" >>"$1"
        [[ $line =~ ^\[[0-9]+/[0-9]+ ]] || continue
        weight=$((weight + $(weight_of <<<"$line")))
        passed=$((SECONDS - began))
        [ "$weight" -lt "$all" ] || all=$weight
        left=$((passed * (all - weight) / (weight > 0 ? weight : 1)))
        printf -v text 'covaria: %d %% built, %d:%02d so far, about %d:%02d left' \
            $((100 * weight / all)) $((passed / 60)) $((passed % 60)) $((left / 60)) $((left % 60))
        if [ -t 2 ]; then
            printf '\r%s   ' "$text" >&2
        elif [ $((10 * weight / all)) -gt "$tenth" ] && [ "$passed" -ge 2 ]; then
            tenth=$((10 * weight / all))
            printf '%s\n' "$text" >&2
        fi
    done
    if [ -t 2 ] && [ "$weight" -gt 0 ]; then echo >&2; fi
}

# prepare TARGET ...: installs, configures and builds everything needed to run those targets.
prepare() {
    install_missing_packages
    cd "$root"
    if [ ! -f "$build/build.ninja" ]; then
        say "configuring ($preset)"
        mkdir -p "$build"
        cmake --preset "$preset" >"$build/configure.log" 2>&1 || { cat "$build/configure.log" >&2; exit 1; }
    fi
    say "building ($preset)"
    read_step_seconds
    local weight
    weight=$(steps_to_build "$@" | weight_of)
    NINJA_STATUS='[%f/%t %e] ' cmake --build --preset "$preset" --target "$@" 2>&1 | show_progress "$build/build.log" "$weight" ||
        { grep -E -A 20 'error|FAILED' "$build/build.log" | head -n 60 >&2; say "the build failed; all of it is in $build/build.log"; exit 1; }
}

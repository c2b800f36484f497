# shellcheck shell=bash
# Building into a directory that several calls may share.
#
#   . tools/lib/build.sh
#   build PRESET [TARGET…]      quiet when there is nothing to do; progress and errors on standard error

# One line that is overwritten on a terminal, a plain line elsewhere; compiler messages are kept either way.
show_progress() {
    local line held=
    while IFS= read -r line; do
        case $line in
            'ninja: no work to do.' | '[0/'*'Re-checking globbed directories'* | '-- GLOB mismatch!') continue ;;
            '['*) if [[ -t 2 ]]; then printf '\r\033[K%.70s' "$line" && held=1 && continue; fi ;;
        esac
        [[ $held ]] && printf '\n' && held=
        printf '%s\n' "$line"
    done >&2
    [[ $held ]] && printf '\r\033[K' >&2
    return 0
}

# Runs the build under a lock on the build directory, so that concurrent calls wait instead of colliding.
build() {
    local preset=$1 target
    shift
    local dir=build/$preset
    local targets=()
    for target in "$@"; do targets+=(--target "$target"); done
    mkdir -p "$dir" || return 1
    (
        flock 9
        # A checkout that was moved or copied brings a build along that still points to the old place.
        if [[ -f $dir/CMakeCache.txt ]] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$dir/CMakeCache.txt"; then
            rm -rf "$dir"
            mkdir -p "$dir"
        fi
        if [[ ! -f $dir/build.ninja ]]; then
            printf 'bioprint-predict: building (once; a minute or two)\n' >&2
            # A configuration that was broken off leaves a cache behind that would be believed.
            rm -f "$dir/CMakeCache.txt"
            if ! cmake --preset "$preset" >"$dir/configure.log" 2>&1; then
                cat "$dir/configure.log" >&2
                exit 1
            fi
        fi
        NINJA_STATUS='[%f/%t] ' cmake --build "$dir" "${targets[@]}" 2>&1 | show_progress
        exit "${PIPESTATUS[0]}"
    ) 9>"$dir.lock" </dev/null
}

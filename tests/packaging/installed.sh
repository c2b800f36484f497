#!/usr/bin/env bash
# Installs a build into an empty prefix and uses it from there as others would: the program, its data, the C++ library through
# find_package, the C library through pkg-config-like flags. usage: installed.sh BUILD_DIR SCRATCH_DIR
set -euo pipefail
build=$(realpath -- "$1")
scratch=$(realpath -m -- "$2")
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
prefix="$scratch/a prefix"

fail() {
    printf 'installed.sh: %s\n' "$*" >&2
    exit 1
}

rm -rf "$scratch"
mkdir -p "$scratch"
cmake --install "$build" --prefix "$prefix" >"$scratch/install.log"

for file in bin/bioprint-predict share/man/man1/bioprint-predict.1 share/bash-completion/completions/bioprint-predict \
    share/doc/bioprint-predict/LICENSE share/bioprint-predict/examples/cpp/exit_load.cpp include/bioprint/bioprint.h; do
    [[ -s $prefix/$file ]] || fail "$file was not installed"
done

# The installed program answers with the source tree out of its sight.
here=$(cd "$scratch" && env -i PATH=/usr/bin:/bin "$prefix/bin/bioprint-predict" --get nozzle.flow_rate)
[[ $here == 3.92699081698724* ]] || fail "the installed program says $here m³/s for the reference case, not π R² u"

# Nothing that is installed speaks of the machine it was built on.
if grep -rlF --include='*.cmake' --include='*.pc' --include='*.h*' -- "$root" "$prefix/include" "$prefix/lib"; then
    fail "the files above name the source folder"
fi

compile() { # EXAMPLE
    {
        cmake -S "$prefix/share/bioprint-predict/examples/$1" -B "$scratch/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release \
            -DCMAKE_PREFIX_PATH="$prefix" && cmake --build "$scratch/$1"
    } >"$scratch/$1.log" 2>&1 && return
    cat "$scratch/$1.log" >&2
    fail "the $1 example does not build against the installed package"
}

compile cpp
"$scratch/cpp/exit-load" >"$scratch/cpp.out"
# At one flow rate a more strongly thinning ink loads cells less, down every line of both columns.
awk 'NR > 1 { if (NR > 2 && ($2 >= wall || $3 >= exit_load)) bad = 1; wall = $2; exit_load = $3 } END { exit bad || NR != 5 }' \
    "$scratch/cpp.out" || { cat "$scratch/cpp.out" >&2 && fail "the C++ example's table is wrong"; }

compile c
"$scratch/c/ask" '{"velocity": "5mm/s"}' '{"radius": "5s"}' 'no JSON' >"$scratch/c.out"
[[ $(wc -l <"$scratch/c.out") == 3 ]] || fail "the C library gave $(wc -l <"$scratch/c.out") lines for three requests"
flow_rate=$(sed -n 1p "$scratch/c.out" | jq .nozzle.flow_rate)
[[ $flow_rate == 3.926990816987* ]] || fail "the C library says $flow_rate m³/s for the reference case"
for line in 2 3; do
    sed -n "${line}p" "$scratch/c.out" | jq -e '.error.message | length > 0' >/dev/null ||
        fail "request $line is wrong, and the answer carries no error: $(sed -n "${line}p" "$scratch/c.out")"
done

library=$(find "$prefix/lib" -name libbioprint.so)
exported=$(nm --dynamic --defined-only --no-demangle "$library" | awk '$2 == "T" || $2 == "W" || $2 == "V" || $2 == "u" { sub(/@.*/, "", $3); print $3 }' | sort | tr '\n' ' ')
[[ $exported == 'bioprint_free bioprint_predict_json bioprint_version ' ]] ||
    fail "libbioprint.so should export three symbols, it exports: $exported"

printf 'installed: program, data, C++ and C library work from %s\n' "$prefix"

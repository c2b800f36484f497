#!/usr/bin/env bash
# tools/predict on a small project in the program's place: what it passes on, what it says, and what it survives.
# usage: predict_script.sh
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
house="$scratch/a house"

fail() {
    printf 'predict_script.sh: %s\n' "$*" >&2
    exit 1
}

mkdir "$house"
cp -r "$root/tools" "$root/CMakePresets.json" "$house"
cat >"$house/CMakeLists.txt" <<'PROJECT'
cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES CXX)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
add_executable(bioprint-predict main.cpp)
PROJECT
cat >"$house/main.cpp" <<'PROGRAM'
#include <cstdio>
#include <cstdlib>
int main(int count, char** words) {
    for (int i = 1; i < count; ++i) std::printf("<%s>", words[i]);
    for (int c = std::getchar(); c != EOF; c = std::getchar()) std::putchar(c);
    return count > 1 ? std::atoi(words[1]) : 0;
}
PROGRAM

# Three first calls at once: one builds, the others wait, all answer.
cd "$scratch"
for name in a b c; do
    {
        status=0
        "$house/tools/predict" 3 "two  words" '' '*' >"$name.out" 2>"$name.err" <<<"typed in $name" || status=$?
        echo "$status" >"$name.status"
    } &
done
wait
for name in a b c; do
    [[ $(<"$name.out") == "<3><two  words><><*>typed in $name" ]] || fail "call $name gave $(<"$name.out"): $(<"$name.err")"
    [[ $(<"$name.status") == 3 ]] || fail "call $name ended with $(<"$name.status"), the program with 3"
done
[[ $(cat ./*.err | grep -c 'building') == 1 ]] || fail "it was not built exactly once"

# The next call says nothing of its own; a link to the script and any folder will do.
ln -s "$house/tools/predict" link
[[ $(cd / && "$scratch/link" 0 2>&1 </dev/null) == '<0>' ]] || fail "a call with nothing to build is not quiet"

# A moved checkout builds again, and answers.
mv "$house" "$scratch/moved"
[[ $("$scratch/moved/tools/predict" 0 2>/dev/null </dev/null) == '<0>' ]] || fail "a moved checkout does not answer"

# A source that does not compile: the compiler's message, and no answer of the old program.
echo 'int main() { return nothing; }' >"$scratch/moved/main.cpp"
status=0
"$scratch/moved/tools/predict" 0 >broken.out 2>broken.err </dev/null || status=$?
[[ $status == 1 && ! -s broken.out ]] || fail "a broken source gave status $status and: $(<broken.out)"
grep -q nothing broken.err || fail "the compiler's message is lost"

printf 'tools/predict: builds once, passes everything on, says what is wrong\n'

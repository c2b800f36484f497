#!/usr/bin/env bash
# What the completion proposes, word by word. usage: completion.sh PROGRAM
set -euo pipefail
program=$(realpath -- "$1")
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
. "$root/completion/bioprint-predict.bash"

# EXPECTED WORD…: the proposals for the last word of a command line, one blank between them
expect() {
    local expected=$1
    shift
    COMP_WORDS=("$program" "$@")
    COMP_CWORD=$#
    _bioprint_predict || true # readline does not look at its status
    if [[ ${COMPREPLY[*]} != "$expected" ]]; then
        printf 'after "%s": proposed "%s", expected "%s"\n' "$*" "${COMPREPLY[*]}" "$expected" >&2
        exit 1
    fi
}

cd "$(mktemp -d)"
trap 'rm -rf "$PWD"' EXIT
touch rows.csv 'my ink.json'

expect '--radius' --rad
expect '--pressure-gradient --pressure' --pres
expect 'json jsonl' --format js
expect 'json jsonl' --format = js
expect 'table json jsonl csv' --format =
expect 'steel tapered hypodermic' --tip ''
expect 'nozzles' --list n
expect 'rows.csv' --batch ro
expect 'rows.csv' -R 50um -o row
[[ $("$program" --list inks | grep -c '^alginate') -gt 1 ]]
expect '25G' --needle 25
expect 'my ink.json' --ink my
expect 'reference' --cell ref
expect '' --radius 5
expect '' 50um
expect '--version' --ink alginate-2.5 --vers
expect '' --cell name
expect 'design' des
expect '--solve' design --sol
expect 'alpha' design --solve al
expect '--check --checkpoint-interval' --che

expect 'fit' 'fi'
expect 'rows.csv' fit ro
expect 'rows.csv' fit --preset ro
expect '--law' fit rows.csv --l
expect 'cross carreau-yasuda' fit rows.csv --law c
expect 'table json csv' fit rows.csv --format =

# Every long option the help names is proposed, and every one proposed is in the help: of the prediction, and of `fit`.
for command in '' fit; do
    # shellcheck disable=SC2086,SC2206
    COMP_WORDS=("$program" $command --)
    COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
    _bioprint_predict
    proposed=$(printf '%s\n' "${COMPREPLY[@]}" | sort)
    # shellcheck disable=SC2086
    offered=$("$program" $command --help | sed '/^Examples:/,$d' | grep -oE '(^|[ ,])--[a-z][a-z0-9-]*' | grep -oE -- '--.*' | sort -u)
    if [[ $proposed != "$offered" ]]; then
        printf 'proposed (<) and in --help (>) differ:\n' >&2
        diff <(printf '%s\n' "$proposed") <(printf '%s\n' "$offered") >&2
        exit 1
    fi
done
printf 'completion: proposals are right\n'

#!/bin/bash
# Joins the pieces of a batch, or says which is missing:   join-pieces.sh runs.piece-*.csv > answers.csv
#
# A piece is what `bioprint-predict --shard K/N --output FILE` wrote into a FILE whose name has K-of-N in it, such as
# runs.piece-3-of-8.csv. The command writes a file whole or not at all, so that a piece that is there is complete.
# Exit status: 0 joined, 2 the call is wrong, 4 a piece is missing, doubled, of another split or batch, or cannot be read; then
# nothing is written.
set -euo pipefail

refuse() {
    printf 'join-pieces: %s\n' "$2" >&2
    exit "$1"
}

(($# > 0)) || refuse 2 "takes the pieces, such as runs.piece-*.csv"
pieces=0
declare -A file_of=()
for file in "$@"; do
    [[ ${file##*/} =~ ([0-9]+)-of-([0-9]+) ]] ||
        refuse 2 "$file: no piece, its name lacks K-of-N; name pieces like runs.piece-3-of-8.csv"
    k=$((10#${BASH_REMATCH[1]})) n=$((10#${BASH_REMATCH[2]}))
    name=${file##*/}
    name=${name/"${BASH_REMATCH[0]}"/K-of-$n}
    ((pieces == 0)) && pieces=$n of=$name
    ((n == pieces)) ||
        refuse 4 "$file: of a split in $n, but ${file_of[*]} of one in $pieces; join one split at a time"
    ((k >= 1 && k <= n)) || refuse 2 "$file: there is no piece $k of $n"
    [[ $name == "$of" ]] || refuse 4 "$file: named otherwise than $of, so of another batch; join one batch at a time"
    [[ -z ${file_of[$k]-} ]] || refuse 4 "$file: piece $k is there twice, the other is ${file_of[$k]}; remove one"
    [[ -r $file ]] || refuse 4 "$file: cannot be read; is its piece answered yet?"
    file_of[$k]=$file
done
missing=()
for ((k = 1; k <= pieces; k++)); do [[ ${file_of[$k]-} ]] || missing+=("$k"); done
((${#missing[@]} == 0)) ||
    refuse 4 "of $pieces pieces these are missing: ${missing[*]}; answer them again with --shard K/$pieces"
head=$(head -n 1 -- "${file_of[1]}")
for ((k = 1; k <= pieces; k++)); do
    file=${file_of[$k]}
    # The last line of the whole may lack its end, as that of the batch did.
    ((k == pieces)) || [[ ! -s $file || -z $(tail -c 1 -- "$file") ]] ||
        refuse 4 "$file: ends within a line, it was cut short; answer it again with --shard $k/$pieces"
    ((k == 1)) || [[ $head != *'nozzle.flow_rate ['* || $(head -n 1 -- "$file") != "$head" ]] ||
        refuse 4 "$file: begins with the head of the table, it is no piece $k; answer it again with --shard $k/$pieces"
done
for ((k = 1; k <= pieces; k++)); do cat -- "${file_of[$k]}"; done

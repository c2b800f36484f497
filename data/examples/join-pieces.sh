#!/bin/bash
# Joins the pieces of a batch, or says which is not whole:
#   join-pieces.sh [--batch FILE | --rows N] [--repeats] runs.piece-*.csv > answers.csv
#
# A piece is what `bioprint-predict --shard K/N --output FILE` wrote into a FILE whose name has K-of-N in it, such as
# runs.piece-3-of-8.csv. The rows of a batch are shared out evenly, the first pieces get one more where they cannot all be
# alike, and no two pieces are the same; --repeats says that the batch repeats its rows. With the batch, or the number of its
# rows, each piece must hold exactly its share; without, a piece may lack a row where that leaves a fair sharing.
# Exit status: 0 joined, 2 the call is wrong, 4 a piece is missing, doubled, cut short, of another split or batch, or cannot be
# read; then nothing is written.
set -euo pipefail

refuse() {
    printf 'join-pieces: %s\n' "$2" >&2
    exit "$1"
}

rows='' batch='' repeats=''
while [[ ${1-} == --* ]]; do
    case $1 in
        --repeats) repeats=yes ;;
        --rows)
            [[ ${2-} =~ ^[0-9]{1,15}$ ]] || refuse 2 "--rows: got '${2-}'; it takes the number of rows of the batch"
            rows=$((10#$2))
            shift
            ;;
        --batch)
            batch=${2-}
            [[ -r $batch && -f $batch ]] || refuse 2 "--batch: '$batch' cannot be read; it takes the file that was shared out"
            shift
            ;;
        *) refuse 2 "$1: unknown; it takes --batch FILE, --rows N and --repeats" ;;
    esac
    shift
done
[[ -z $rows || -z $batch ]] || refuse 2 "--rows: the batch tells; leave out one of --rows and --batch"
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

again() { printf 'answer it again with --shard %s/%s' "$1" "$pieces"; }

# The head of a CSV holds this name, in piece 1, perhaps behind a preamble.
marked='nozzle.flow_rate ['
csv=$(head -c 65536 -- "${file_of[1]}" | grep -acF "$marked" || true)
((csv > 0)) || csv=''
head=$(head -n 1 -- "${file_of[1]}")
filled=0
for ((k = 1; k <= pieces; k++)); do [[ ! -s ${file_of[$k]} ]] || filled=$k; done
for ((k = 1; k <= pieces; k++)); do
    file=${file_of[$k]}
    # The last line of the whole may lack its end, as that of the batch did.
    ((k == filled)) || [[ ! -s $file || -z $(tail -c 1 -- "$file") ]] ||
        refuse 4 "$file: ends within a line, it was cut short; $(again "$k")"
    ((k == 1)) || [[ -z $csv || $(head -n 1 -- "$file") != "$head" ]] ||
        refuse 4 "$file: begins with the head of the table, it is no piece $k; $(again "$k")"
done

# Rows of a piece. A field of a CSV in quotes may hold line ends, and the head is no row; elsewhere a row is a line.
rows_of() {
    LC_ALL=C awk -v csv="$csv" -v first="$1" -v marked="$marked" '
        function scan(text,    i, c, before) {
            before = ""
            for (i = 1; i <= length(text); i++) {
                c = substr(text, i, 1)
                if (quoted) { if (c == "\"") quoted = 0 }
                else if (c == "\"" && (before == "" || before ~ /[,;\t"]/)) { quoted = 1; opened = NR }
                before = c
            }
        }
        {
            if (csv && index($0, "\"")) scan($0)
            if (csv && first == 1 && !seen) seen = index($0, marked) > 0
            else if (!quoted) count++
        }
        END { print count + (quoted ? NR - opened + 1 : 0) }' "$2"  # a quote that is never closed opens nothing
}
counts=() total=0
for ((k = 1; k <= pieces; k++)); do
    counts[k]=$(rows_of "$k" "${file_of[$k]}")
    ((total += counts[k])) || true
done
known="they hold $total"
if [[ $batch ]]; then
    plan=$(bioprint-predict --batch "$batch" --dry-run --format jsonl) ||
        refuse 4 "--batch: bioprint-predict cannot read '$batch'; see above"
    [[ $plan =~ \"records\":([0-9]+) ]] || refuse 4 "--batch: this bioprint-predict does not count the rows of '$batch'; give --rows"
    rows=${BASH_REMATCH[1]}
fi
if [[ $rows ]]; then
    known="the batch has $rows"
else
    # The fairest sharing that some piece speaks for: what the largest one would have.
    largest=0
    for ((k = 1; k <= pieces; k++)); do ((counts[k] <= largest)) || largest=${counts[k]} last=$k; done
    rows=$total
    ((largest == 0)) || for ((k = last; k >= 1; k--)); do ((counts[k] >= largest)) || refuse 4 \
        "${file_of[$k]}: holds ${counts[k]} rows and piece $last, behind it, $largest; it was cut short; $(again "$k")"; done
    for ((k = 1; k <= pieces; k++)); do
        ((counts[k] >= largest - 1)) ||
            refuse 4 "${file_of[$k]}: holds ${counts[k]} rows and piece $last $largest, but pieces differ by one at most; $(again "$k")"
    done
fi
for ((k = 1; k <= pieces; k++)); do
    share=$((rows / pieces + (k <= rows % pieces ? 1 : 0)))
    ((counts[k] == share)) ||
        refuse 4 "${file_of[$k]}: holds ${counts[k]} rows where piece $k of $pieces has $share, for $known; $(again "$k")"
done
if [[ -z $repeats ]]; then
    declare -A piece_of=()
    for ((k = 1; k <= pieces; k++)); do
        [[ -s ${file_of[$k]} ]] || continue
        sum=$(cksum <"${file_of[$k]}")
        twin=${piece_of[$sum]-}
        [[ -z $twin ]] || ! cmp -s -- "${file_of[$k]}" "${file_of[$twin]}" ||
            refuse 4 "${file_of[$k]}: the same as piece $twin; $(again "$k"), or say --repeats if the batch repeats its rows"
        piece_of[$sum]=$k
    done
fi
for ((k = 1; k <= pieces; k++)); do cat -- "${file_of[$k]}"; done

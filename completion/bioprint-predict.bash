# shellcheck shell=bash
# Completion of bioprint-predict in bash: options, the values they take, names of presets, files.
# Presets are asked of the program itself, so that the list is that of the version in use.

_bioprint_predict_presets() { # PROGRAM inks|cells|nozzles
    # The first line is the head of the table; a gauge stands once for each of its tips.
    "$1" --list "$2" 2>/dev/null | awk 'NR > 1 && NF && !seen[$1]++ { print $1 }'
}

_bioprint_predict_fit() { # the words after `fit`
    local words
    case $previous in
        -f | --format) words='table json csv' ;;
        --law) words='cross newtonian power-law carreau-yasuda herschel-bulkley best' ;;
        --eta-inf) words='fit' ;;
        --interval | --name | --get) return ;;
        *)
            if [[ $current != -* || $previous == -o || $previous == --output || $previous == --preset || $previous == --plot ]]; then
                compopt -o filenames 2>/dev/null
                mapfile -t COMPREPLY < <(compgen -f -- "$current")
                return
            fi
            words='--law --interval --eta-inf --name --preset --plot -f --format --json --get -o --output -q --quiet --no-color
                -h --help'
            ;;
    esac
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}

_bioprint_predict() {
    local program=${COMP_WORDS[0]} current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
    COMPREPLY=()

    # Readline hands `--format=json` over in three words; the value is completed as after a blank.
    if [[ $current == '=' ]]; then
        current=
    elif [[ $previous == '=' ]]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    fi

    if [[ ${COMP_WORDS[1]} == fit ]] && ((COMP_CWORD > 1)); then
        _bioprint_predict_fit
        return
    fi
    if ((COMP_CWORD == 1)) && [[ -n $current && fit == "$current"* ]]; then
        COMPREPLY=(fit)
        return
    fi

    local words
    case $previous in
        -f | --format) words='table json jsonl csv' ;;
        --solve) words='radius flowrate velocity pressure pressure-gradient alpha' ;;
        --tip) words='steel tapered hypodermic' ;;
        --model) words='ellipsoid steady' ;;
        --law) words='cross power-law carreau-yasuda herschel-bulkley' ;;
        --simulate) words='auto shear channel exit-flow exit' ;;
        --plot-kind) words='overview profile exit cell nomogram' ;;
        --fidelity) words='draft standard fine' ;;
        --list) words='inks cells nozzles' ;;
        --needle) words=$(_bioprint_predict_presets "$program" nozzles) ;;
        --cell) words=$(_bioprint_predict_presets "$program" cells) ;;
        --ink)
            words=$(_bioprint_predict_presets "$program" inks)
            mapfile -t COMPREPLY < <(compgen -f -- "$current")
            ;;
        --batch | --history | --plot | --report | -o | --output)
            compopt -o filenames 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -f -- "$current")
            return
            ;;
        --out | --resume)
            compopt -o filenames 2>/dev/null
            mapfile -t COMPREPLY < <(compgen -d -- "$current")
            return
            ;;
        -R | --radius | --diameter | -Q | --flowrate | --velocity | --pressure-gradient | --pressure | --length | \
            --eta0 | --eta-inf | -K | --time-constant | -a | --alpha | --consistency | --flow-index | --yield-stress | --transition | --cell-radius | --shear-modulus | \
            --poisson-ratio | --viscosity-ratio | --offset | --threshold | --profile | --get | --check | --samples | --limit | --range | --resolution | --shard | \
            --fluid-stress | --channel-time | --checkpoint-interval | --snapshots | -j | --jobs)
            return # a quantity: nothing to propose
            ;;
        *)
            if [[ $COMP_CWORD == 1 && $current != -* && -n $current ]]; then
                mapfile -t COMPREPLY < <(compgen -W 'design' -- "$current")
                return
            fi
            [[ $current == -* || -z $current ]] || return
            words='-R --radius --diameter --needle --tip -Q --flowrate --velocity --pressure-gradient --pressure --length
                --ink --law --eta0 --eta-inf -K --time-constant -a --alpha --consistency --flow-index --yield-stress --transition
                --cell --cell-radius --shear-modulus --poisson-ratio --viscosity-ratio --offset
                --model --population --threshold --profile --batch -f --format --json --get --check
                --uncertainty --samples --history -o --output
                --plot --plot-kind --report --shard
                -j --jobs -q --quiet -v --verbose --no-color --list --simulate --fidelity --resolution
                --fluid-stress --channel-time --tolerance --budget --explain --dry-run --out --resume --checkpoint-interval --snapshots --version -h --help'
            [[ ${COMP_WORDS[1]} == design ]] && words+=' --solve --limit --range'
            ;;
    esac
    local proposals
    mapfile -t proposals < <(compgen -W "$words" -- "$current")
    COMPREPLY+=("${proposals[@]}")
}

complete -F _bioprint_predict bioprint-predict

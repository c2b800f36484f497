# shellcheck shell=bash
# Completion of bioprint-predict in bash: options, the values they take, names of presets, files.
# Presets are asked of the program itself, so that the list is that of the version in use.

_bioprint_predict_presets() { # PROGRAM inks|cells|nozzles
    # The first line is the head of the table; a gauge stands once for each of its tips.
    "$1" --list "$2" 2>/dev/null | awk 'NR > 1 && NF && !seen[$1]++ { print $1 }'
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

    local words
    case $previous in
        -f | --format) words='table json jsonl csv' ;;
        --tip) words='steel tapered hypodermic' ;;
        --model) words='ellipsoid steady' ;;
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
            --eta0 | --eta-inf | -K | --time-constant | -a | --alpha | --cell-radius | --shear-modulus | \
            --poisson-ratio | --viscosity-ratio | --offset | --threshold | --profile | --get | --resolution | --shard | \
            --fluid-stress | --channel-time | --checkpoint-interval | -j | --jobs)
            return # a quantity: nothing to propose
            ;;
        *)
            [[ $current == -* || -z $current ]] || return
            words='-R --radius --diameter --needle --tip -Q --flowrate --velocity --pressure-gradient --pressure --length
                --ink --eta0 --eta-inf -K --time-constant -a --alpha
                --cell --cell-radius --shear-modulus --poisson-ratio --viscosity-ratio --offset
                --model --population --threshold --profile --batch -f --format --json --get --history -o --output
                --plot --plot-kind --report --shard
                -j --jobs -q --quiet -v --verbose --no-color --list --simulate --fidelity --resolution
                --fluid-stress --channel-time --tolerance --budget --explain --dry-run --out --resume --checkpoint-interval --version -h --help'
            ;;
    esac
    local proposals
    mapfile -t proposals < <(compgen -W "$words" -- "$current")
    COMPREPLY+=("${proposals[@]}")
}

complete -F _bioprint_predict bioprint-predict

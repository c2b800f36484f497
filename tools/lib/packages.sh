# shellcheck shell=bash disable=SC2034 # the lists are read by the scripts that source this file
# Debian packages the project needs, and a way to install those that are missing.
#
#   . tools/lib/packages.sh
#   need_packages "${build_packages[@]}"      0: all there;  1: could not be installed (said why)
#
# Nothing is asked of apt while everything is there; the look costs about 10 ms.

# To build and run the program.
build_packages=(
    g++ cmake ninja-build
    libgsl-dev         # roots, quadrature, least squares
    libeigen3-dev      # small matrices
    libcli11-dev       # the command line
    nlohmann-json3-dev # JSON in and out
)

# To run every test as well.
test_packages=(
    doctest-dev        # unit tests
    librapidcheck-dev  # property tests
    libvalijson-dev    # answers against their JSON Schema
    libudunits2-dev    # oracle of the unit table
    python3-meshio     # reads ParaView files
    python3-mpmath     # references of 50 digits
    clang-format clang-tidy
    git jq man-db mandoc python3 shellcheck
    gnuplot-nox        # draws the pictures
    libxlsxwriter-dev  # Excel workbooks; optional when building
    python3-openpyxl   # reads them back
    parallel           # examples of the manual
)

# To hunt for crashes with libFuzzer (not part of the test command).
fuzz_packages=(clang libclang-rt-14-dev)

# For the tests by hand (label campaign): reports in a browser, macros and CSV in a spreadsheet, an array job.
campaign_packages=(chromium libreoffice-calc libreoffice-l10n-de slurm-wlm munge)

# Prints those of the packages named that are not installed, one a line.
missing_packages() {
    local name status
    local -A installed=()
    while read -r status name; do
        [[ $status == ii ]] && installed[${name%%:*}]=1
    done < <(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' "$@" 2>/dev/null)
    for name in "$@"; do
        [[ ${installed[$name]-} ]] || printf '%s\n' "$name"
    done
}

need_packages() {
    if ! command -v dpkg-query >/dev/null; then
        # Not a Debian system: whoever builds here installs by other means, and CMake names what it misses.
        return 0
    fi
    local missing as_root=() log
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]} == 0)) && return 0

    local by_hand="apt-get install ${missing[*]}"
    printf 'bioprint-predict: installing %s\n' "${missing[*]}" >&2
    if ((EUID != 0)); then
        if ! command -v sudo >/dev/null; then
            printf 'bioprint-predict: this needs root and there is no sudo; as root: %s\n' "$by_hand" >&2
            return 1
        fi
        as_root=(sudo)
    fi
    # A lock held by another apt is waited for, two minutes at most; a question is never asked.
    local apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -qq
        -o DPkg::Lock::Timeout=120 -o Acquire::Retries=3)
    local install=("${apt[@]}" install --no-install-recommends "${missing[@]}")
    log=$(mktemp) || return 1
    local attempt
    for attempt in 1 2 3 4; do
        # The package lists of a fresh machine are empty or old; only then is the network asked for new ones.
        if "${install[@]}" >"$log" 2>&1 </dev/null ||
            { "${apt[@]}" update && "${install[@]}"; } >"$log" 2>&1 </dev/null; then
            rm -f "$log"
            return 0
        fi
        # The lock of the package lists has no timeout of its own.
        grep -q 'Could not get lock' "$log" || break
        ((attempt < 4)) && sleep "${BIOPRINT_APT_PAUSE-20}"
    done
    {
        tail -n 15 "$log"
        printf 'bioprint-predict: the packages could not be installed; is there a network?\n'
        printf '    by hand: %s%s\n' "${as_root:+sudo }" "$by_hand"
    } >&2
    rm -f "$log"
    return 1
}

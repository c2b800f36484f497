#!/usr/bin/env bash
# tools/install-packages against stand-ins for dpkg-query, apt-get and sudo: what it asks for, and what it says when it cannot.
# usage: install_packages.sh
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export scratch
mkdir "$scratch/bin"

fail() {
    printf 'install_packages.sh: %s\n' "$*" >&2
    sed 's/^/    /' "$scratch/calls" "$scratch/stderr" >&2
    exit 1
}

# dpkg-query knows the packages listed in $scratch/installed; apt-get notes its call, fails as often as
# $scratch/failures says and otherwise installs.
cat >"$scratch/bin/dpkg-query" <<'STAND_IN'
#!/bin/bash
for name in "${@:3}"; do
    if grep -qx -- "$name" "$scratch/installed"; then echo "ii  $name"; else echo "no packages found matching $name" >&2; fi
done
STAND_IN
cat >"$scratch/bin/apt-get" <<'STAND_IN'
#!/bin/bash
echo "apt-get $* [$DEBIAN_FRONTEND]" >>"$scratch/calls"
left=$(<"$scratch/failures")
if ((left > 0)); then
    echo $((left - 1)) >"$scratch/failures"
    cat "$scratch/complaint" >&2
    exit 100
fi
[[ $* == *' install '* ]] && printf '%s\n' "${@##-*}" >>"$scratch/installed"
exit 0
STAND_IN
cat >"$scratch/bin/sudo" <<'STAND_IN'
#!/bin/bash
echo sudo >>"$scratch/calls"
exec "$@"
STAND_IN
chmod +x "$scratch"/bin/*

all_packages() { (. "$root/tools/lib/packages.sh" && printf '%s\n' "${build_packages[@]}"); }

# FAILURES COMPLAINT: one run of the tool, its status in $status
run() {
    echo "$1" >"$scratch/failures"
    echo "$2" >"$scratch/complaint"
    : >"$scratch/calls"
    status=0
    BIOPRINT_APT_PAUSE=0 PATH="$scratch/bin:$PATH" "$root/tools/install-packages" build \
        >"$scratch/stdout" 2>"$scratch/stderr" || status=$?
    [[ ! -s $scratch/stdout ]] || fail "nothing belongs on standard output"
}
calls() { grep -c "$1" "$scratch/calls" || true; }

all_packages >"$scratch/installed"
run 0 ''
((status == 0)) || fail "nothing is missing, and the status is $status"
[[ ! -s $scratch/calls ]] || fail "nothing is missing, and apt was asked"
[[ ! -s $scratch/stderr ]] || fail "nothing is missing, and something was said"

all_packages | grep -vx -e libgsl-dev -e libcli11-dev >"$scratch/installed"
run 0 ''
((status == 0)) || fail "two packages could be installed, and the status is $status"
[[ $(calls apt-get) == 1 ]] || fail "one call of apt-get is enough when its lists are good"
grep -q 'install .*libgsl-dev libcli11-dev \[noninteractive\]$' "$scratch/calls" || fail "not exactly what is missing"
grep -q 'installing libgsl-dev libcli11-dev' "$scratch/stderr" || fail "it does not say what it installs"

all_packages | grep -vx libgsl-dev >"$scratch/installed"
run 1 'E: Unable to locate package libgsl-dev'
((status == 0)) || fail "old package lists are refreshed, and the status is $status"
[[ $(calls ' update ') == 1 && $(calls ' install ') == 2 ]] || fail "install, update, install was due"

all_packages | grep -vx libgsl-dev >"$scratch/installed"
run 2 'E: Could not get lock /var/lib/apt/lists/lock'
((status == 0)) || fail "a lock is waited for, and the status is $status"

all_packages | grep -vx libgsl-dev >"$scratch/installed"
run 99 'E: Failed to fetch'
((status != 0)) || fail "no network, and the status is 0"
grep -q 'is there a network' "$scratch/stderr" || fail "it does not say what is wrong"
grep -q 'by hand: .*apt-get install libgsl-dev$' "$scratch/stderr" || fail "it does not say what to do"

printf 'install-packages: asks for what is missing and for nothing else\n'

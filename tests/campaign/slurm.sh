#!/bin/bash
# One-node Slurm on this machine: submits data/examples/slurm-array.sh as it is, waits for its tasks, joins the pieces
# and compares them with the whole, byte for byte. By hand, as root of a machine that can spare the packages:
#
#   apt-get install --no-install-recommends slurm-wlm munge
#   tests/campaign/slurm.sh build/release/bin/bioprint-predict
#
# Everything it starts lives in a folder of its own and is ended with it. Exit status: 0 equal, 1 not, 77 no Slurm here.
set -euo pipefail

program=$(realpath "${1:?takes the program, such as build/release/bin/bioprint-predict}")
examples=$(realpath "$(dirname "$0")/../../data/examples")
for need in munged slurmctld slurmd sbatch; do
    PATH=$PATH:/usr/sbin command -v "$need" >/dev/null || { echo "skipped: $need is not installed"; exit 77; }
done
((EUID == 0)) || { echo "skipped: the daemons need root"; exit 77; }
export PATH=$PATH:/usr/sbin
folder=$(mktemp -d /tmp/slurm-XXXXXX)
chmod 755 "$folder"
pids=()
finish() {
    for pid in "${pids[@]}"; do kill "$pid" 2>/dev/null || true; done
    wait 2>/dev/null || true
    rm -rf "$folder"
}
trap finish EXIT

mkdir -m 700 "$folder/munge"
dd if=/dev/urandom of="$folder/munge/key" bs=1 count=1024 status=none
chmod 400 "$folder/munge/key"
chmod 711 "$folder/munge"
munged --foreground --force --key-file="$folder/munge/key" --socket="$folder/munge/socket" \
    --pid-file="$folder/munge/pid" --seed-file="$folder/munge/seed" --log-file="$folder/munge/log" &
pids+=($!)

host=$(hostname -s)
export SLURM_CONF=$folder/slurm.conf
cat >"$SLURM_CONF" <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=sched_min_interval=100000
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=10 State=UP
CONF
mkdir "$folder/state" "$folder/spool"
slurmctld -D >/dev/null 2>&1 &
pids+=($!)
slurmd -D >/dev/null 2>&1 &
pids+=($!)
for ((i = 0; i < 60; i++)); do
    [[ $(sinfo -h -o %T 2>/dev/null) == idle ]] && break
    sleep 0.5
done
if [[ $(sinfo -h -o %T 2>/dev/null) != idle ]]; then
    echo "skipped: Slurm does not come up here"
    tail -n 5 "$folder"/slurm*.log "$folder/munge/log" || true
    exit 77
fi

mkdir "$folder/bin" "$folder/work"
ln -s "$program" "$folder/bin/bioprint-predict"
export PATH=$folder/bin:$PATH
cd "$folder/work"
{
    echo "name,radius [um],alpha"
    for ((i = 0; i < 500; i++)); do echo "run $i,$((40 + i % 60)),0.$((i % 9))"; done
    echo "bad,-1,0.5"
} >runs.csv
status=0
bioprint-predict -q --batch runs.csv --output whole.csv || status=$?
((status == 6)) || { echo "the whole ended with $status"; exit 1; }
sbatch --wait "$examples/slurm-array.sh" runs.csv
"$examples/join-pieces.sh" runs.piece-*.csv >answers.csv
cmp whole.csv answers.csv
pieces=(runs.piece-*.csv)
echo "equal: ${#pieces[@]} pieces, $(wc -l <answers.csv) lines, by $(sbatch --version)"

#!/bin/bash
#SBATCH --job-name=bioprint
#SBATCH --array=1-8
#SBATCH --cpus-per-task=1
#SBATCH --time=00:10:00
# A batch in eight pieces, one a task:   sbatch slurm-array.sh runs.csv
# When all are done:                     cat runs.piece-*.csv > answers.csv
set -euo pipefail
batch=$1
task=$SLURM_ARRAY_TASK_ID
# Pieces sort as they count, so that the shell joins them in order.
piece=$(printf '%s.piece-%04d.csv' "${batch%.csv}" "$task")
status=0
bioprint-predict -q --batch "$batch" --shard "$task/$SLURM_ARRAY_TASK_COUNT" \
    --jobs "${SLURM_CPUS_PER_TASK:-1}" --output "$piece" || status=$?
# 6: some rows have no answer and say why in their place; the piece is whole.
((status == 0 || status == 6)) || exit "$status"
